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

// Something that the program uses if it is installed, and "ok" or what to install.
struct ExternalNeed {
  std::string name;
  std::string state;
};

// What works here and what is missing; `needs` are listed too. `healthy` is false when no film can
// be made.
struct Diagnosis {
  std::string text;
  bool healthy = true;
};
Diagnosis examine(const std::vector<ExternalNeed>& needs);

}  // namespace polhode
