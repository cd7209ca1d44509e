// SPDX-License-Identifier: MIT
// The command `schema`: the JSON Schema of the scene file.
#pragma once

#include <string>

namespace polhode {

// Indented.
std::string schema_text();

}  // namespace polhode
