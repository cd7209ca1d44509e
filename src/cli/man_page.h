// SPDX-License-Identifier: MIT
// Manual pages, from the same commands and options as --help.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace polhode {

// polhode(1) in the man(7) macros. `program` has all its commands.
std::string program_man_page(const CLI::App& program);

// polhode-COMMAND(1).
std::string command_man_page(const CLI::App& program, const CLI::App& command);

}  // namespace polhode
