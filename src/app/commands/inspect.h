// SPDX-License-Identifier: MIT
// The use case `inspect`: what a scene's body is, how its motion is found, and what theory says.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "film/overrides.h"
#include "film/solved_scene.h"

namespace polhode {

struct InspectJob {
  std::filesystem::path scene;
  Overrides overrides;
  bool json = false;
};

// Keys carry their units. Vectors in body axes, moments ascending about `reference`.
nlohmann::ordered_json inspection(const Solved& solved);

// The whole answer: aligned columns, or indented JSON.
std::string inspect(const InspectJob& job);

}  // namespace polhode
