// SPDX-License-Identifier: MIT
// The command `list`: prints the tables of the program (methods, solids, formats, ...).
#pragma once

#include <string>
#include <vector>

namespace polhode {

// The names of the tables.
std::vector<std::string> list_names();

// The table of that name, as aligned columns. Throws Error (input), without a key, for an unknown
// name or if the shipped scenes are missing.
std::string list_table(const std::string& name);

}  // namespace polhode
