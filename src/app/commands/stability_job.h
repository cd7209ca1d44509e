// SPDX-License-Identifier: MIT
// The options of `stability`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/system/progress.h"

namespace polhode {

// As the user gave them.
struct StabilityJob {
  std::vector<std::filesystem::path> scenes;
  std::string output;   // folder, created if needed
  std::string methods;  // comma-separated names; empty: all that can integrate the scene
  std::string x = "numerics.step";  // key of the scene, or "spin": a factor on its initial spin
  std::string y = "spin";           // the same
  std::optional<std::string> x_range, y_range;  // "0.1:10"; absent: around the scene's value
  std::string cells = "64x64";                  // columns x rows
  double turns = 100.0;      // length of a run, in turns of the body at its typical rate
  double allowed_rad = 0.1;  // allowed attitude error
  int jobs = 0;              // threads; 0: one per processor
  ProgressKind progress = ProgressKind::automatic;
};

}  // namespace polhode
