// SPDX-License-Identifier: MIT
#include "app/commands/schema.h"

#include <nlohmann/json.hpp>

#include "scene/schema.h"

namespace polhode {

std::string schema_text(bool of_films) {
  return (of_films ? film_schema() : scene_schema()).dump(2) + "\n";
}

}  // namespace polhode
