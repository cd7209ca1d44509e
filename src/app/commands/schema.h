// SPDX-License-Identifier: MIT
// The command `schema`: prints the JSON Schema of the scene file.
#pragma once

#include <string>

namespace polhode {

// scene_schema() as indented JSON.
std::string schema_text();

}  // namespace polhode
