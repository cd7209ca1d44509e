// SPDX-License-Identifier: MIT
// What is asked of `stability`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/system/progress.h"

namespace polhode {

struct StabilityJob {
  std::vector<std::filesystem::path> scenes;
  std::string output;               // folder, made when it is missing
  std::string methods;              // names with commas between; empty: all that can take the scene
  std::string x = "numerics.step";  // keys of the scene, or "spin": a factor on its spin
  std::string y = "spin";
  std::optional<std::string> x_range, y_range;  // "0.1:10"; absent: around the scene's own value
  std::string cells = "64x64";
  double turns = 100.0;      // how far the body turns in a run
  double allowed_rad = 0.1;  // attitude error of what passes for fine
  int jobs = 0;              // threads; 0: as many as processors
  ProgressKind progress = ProgressKind::automatic;
};

}  // namespace polhode
