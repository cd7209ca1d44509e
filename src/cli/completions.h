// SPDX-License-Identifier: MIT
// Makes completion scripts for shells from the commands and options that --help shows.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace polhode {

// The completion script for bash, and that for zsh. `program` must already have all its subcommands
// with their options.
std::string bash_completion(const CLI::App& program);
std::string zsh_completion(const CLI::App& program);

}  // namespace polhode
