// SPDX-License-Identifier: MIT
// The JSON Schemas of scene and film files, made from the field lists that also read it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace polhode {

// JSON Schema draft 2020-12, with all keys, unit suffixes, allowed names and ranges, and with keys
// that exclude each other.
nlohmann::ordered_json scene_schema();
// Likewise, of film files (scene/film_file.h). Tables of scenes may be incomplete there.
nlohmann::ordered_json film_schema();

}  // namespace polhode
