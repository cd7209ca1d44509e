// SPDX-License-Identifier: MIT
// The command `schema`: prints the JSON Schema of the scene file.
#pragma once

#include <string>

namespace polhode {

// The JSON Schema of scene files, scene_schema() (scene/schema.h), as indented JSON. Its
// descriptions are the Doc texts of the specs (base/fields.h).
std::string schema_text();

}  // namespace polhode
