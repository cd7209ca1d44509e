// SPDX-License-Identifier: MIT
// The command `list`: the tables of what the program knows, as text.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// What can be listed.
std::vector<std::string> list_names();

// The table of that name. Throws Error (input).
std::string list_table(const std::string& name);

}  // namespace polhode
