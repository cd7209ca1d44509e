// SPDX-License-Identifier: MIT
// Makes completion scripts for shells from the commands and options that --help shows.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace polhode {

// The script for a shell. `program` must have all its commands.
std::string bash_completion(const CLI::App& program);
std::string zsh_completion(const CLI::App& program);

}  // namespace polhode
