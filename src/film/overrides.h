// SPDX-License-Identifier: MIT
// What the command line may say in place of a scene's own values.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace polhode {

// Absent: the scene's value holds.
struct Overrides {
  std::optional<std::string> method;
  std::optional<double> step;  // s
  std::optional<double> tolerance;
  std::optional<std::string> accuracy;  // "0.1px" or radians
  std::optional<std::string> size;      // "1920x1080"
  std::optional<std::string> fps;       // "60" or "30000/1001"
  bool loop = false;                    // ends the film where the motion is back at its start
};

// The scene with the overrides applied. Throws Error (input) with file, line and key, or the
// option.
Scene load_with_overrides(const std::filesystem::path& file, const Overrides& overrides);

}  // namespace polhode
