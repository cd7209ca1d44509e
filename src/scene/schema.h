// SPDX-License-Identifier: MIT
// The JSON Schemas of scene and film files, made from the field lists that also read it.
#pragma once

#include "base/json.h"

namespace polhode {

// JSON Schema draft 2020-12, with all keys, unit suffixes, allowed names and ranges, and with keys
// that exclude each other.
Json scene_schema();
// Likewise, of film files (scene/film_file.h). Tables of scenes may be incomplete there.
Json film_schema();

}  // namespace polhode
