// SPDX-License-Identifier: MIT
// Completions for shells, from the same commands and options as --help.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace polhode {

// Scripts that the shell reads. `program` has all its commands.
std::string bash_completion(const CLI::App& program);
std::string zsh_completion(const CLI::App& program);

}  // namespace polhode
