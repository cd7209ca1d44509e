// SPDX-License-Identifier: MIT
// Values of a scene that options of the command line can override.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace polhode {

// Absent values: the scene's own are used.
struct Overrides {
  std::optional<std::string> method;
  std::optional<double> step;           // s
  std::optional<double> tolerance;      // relative, of adaptive methods
  std::optional<std::string> accuracy;  // "0.1px" or radians
  std::optional<std::string> size;      // "1920x1080"
  std::optional<std::string> fps;       // "60" or "30000/1001"
  bool loop = false;                    // true: end the film where the motion is back at its start
};

// Loads a scene and applies the overrides. Throws Error (input) with file, line and key as
// load_scene does, or naming the option (--method, --step, --size, ...).
Scene load_with_overrides(const std::filesystem::path& file, const Overrides& overrides);

}  // namespace polhode
