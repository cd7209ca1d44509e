// SPDX-License-Identifier: MIT
// The command `schema`: prints the JSON Schema of scene or film files.
#pragma once

#include <string>

namespace polhode {

// The JSON Schema of scene files, scene_schema() (scene/schema.h), or of film files, as indented
// JSON. Its descriptions are the Doc texts of the specs (base/fields.h).
std::string schema_text(bool of_films);

}  // namespace polhode
