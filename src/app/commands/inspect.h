// SPDX-License-Identifier: MIT
// The command `inspect`: the mass properties of a body, how its motion is computed, and what theory
// says about it.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "film/overrides.h"
#include "film/solved_scene.h"

namespace polhode {

// The options of `inspect`.
struct InspectJob {
  std::filesystem::path scene;
  Overrides overrides;
  bool json = false;
};

// The values as JSON. Keys have their unit as suffix. Vectors are in body axes B; principal moments
// are in ascending order, about the point `reference`.
nlohmann::ordered_json inspection(const Solved& solved);

// The output of the command: aligned columns, or indented JSON. Throws Error as load_with_overrides
// and solve do.
std::string inspect(const InspectJob& job);

}  // namespace polhode
