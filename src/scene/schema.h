// SPDX-License-Identifier: MIT
// A JSON Schema of the scene file, made from the same field lists that read it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace polhode {

// Draft 2020-12. Every key, every unit suffix, allowed names, ranges, which keys exclude each
// other.
nlohmann::ordered_json scene_schema();

}  // namespace polhode
