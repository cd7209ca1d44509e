// SPDX-License-Identifier: MIT
// What CLI11 does not understand, in our words.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/error.h"

namespace polhode {

// Throws Error (input) at the first word that is not UTF-8: names and texts go into reports, films
// and pages, which are.
void refuse_words_in_other_encodings(const std::vector<std::string>& words);

// Throws Error (input), with the nearest command, if the first word is no option and no command.
void refuse_unknown_command(const std::vector<std::string>& words);

// The complaint about the words of a command line (without the program); a mistyped option gets the
// nearest one of its command.
Error explain(const CLI::ParseError& error,
              const CLI::App& app,
              const std::vector<std::string>& words);

// `submit` hands over what follows the command that it names, such as "render": puts "--" before
// that, so that options after it are not taken for those of `submit`. Other commands stay.
std::vector<std::string> with_work_apart(const CLI::App& app, std::vector<std::string> words);

// Parses words, the first first. Throws Error (input) for an option with nothing behind its '=',
// and what CLI::App::parse throws.
void parse_words(CLI::App& app, const std::vector<std::string>& words);

}  // namespace polhode
