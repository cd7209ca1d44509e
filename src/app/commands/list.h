// SPDX-License-Identifier: MIT
// The use cases `list`, `schema` and `doctor`: what the program knows, as text.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// What can be listed.
std::vector<std::string> list_names();

// The table of that name. Throws Error (input).
std::string list_table(const std::string& name);

// The JSON Schema of the scene file, indented.
std::string schema_text();

// What works here and what is missing. `healthy` is false when no film can be made.
struct Diagnosis {
  std::string text;
  bool healthy = true;
};
Diagnosis examine();

}  // namespace polhode
