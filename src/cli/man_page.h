// SPDX-License-Identifier: MIT
// Makes manual pages from the commands and options that --help shows.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace polhode {

// The page polhode(1), in man(7) macros. `program` must already have all its subcommands.
std::string program_man_page(const CLI::App& program);

// The page polhode-COMMAND(1). `command`: one of the subcommands of `program`, with its options.
std::string command_man_page(const CLI::App& program, const CLI::App& command);

}  // namespace polhode
