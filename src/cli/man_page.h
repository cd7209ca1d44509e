// SPDX-License-Identifier: MIT
// Makes manual pages from the commands and options that --help shows.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace polhode {

// polhode(1) in man(7) macros. `program` must have all its commands.
std::string program_man_page(const CLI::App& program);

// polhode-COMMAND(1).
std::string command_man_page(const CLI::App& program, const CLI::App& command);

}  // namespace polhode
