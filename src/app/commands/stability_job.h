// SPDX-License-Identifier: MIT
// The options of `stability`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/piecewise.h"
#include "base/system/progress.h"
#include "scene/scene.h"
#include "scene/setting.h"

namespace polhode {

// The options as the user gave them. make_place() (app/commands/mapped_scene.h) checks the axes.
struct StabilityJob {
  std::vector<std::filesystem::path> scenes;  // at least one
  std::vector<Setting> settings;              // --set, for each scene
  std::string output;   // folder, created if needed; empty: output/SCENE_stability of the first
  std::string methods;  // names, separated by commas; empty: all that can integrate the scene
  // the keys that change along the horizontal and the vertical axis: a key of the scene with a
  // number, or "spin", a factor on the angular momentum at the start
  std::string x = "numerics.step";
  std::string y = "spin";
  // first and last value of the axes, "0.1:10", in the unit of the key as it is spelled; the last
  // is greater, and for the step and the spin both are positive. Absent: a tenth to ten times a
  // middle value, which is 1 / typical_rate() (motion/scales.h) for the step, 1 for the spin, and
  // the scene's value for other keys; if the scene's value v is negative, 2 v to -2 v; if it is 0,
  // -1 to 1
  std::optional<std::string> x_range, y_range;
  std::string cells = "64x64";  // columns x rows, each 2 to 1024
  double turns = 100.0;         // length of a run: this many times 2 pi / typical_rate(); positive
  double allowed_rad = 0.1;     // allowed attitude error, rad; positive
  int jobs = 0;                 // threads; 0: one per processor
  PartOptions part;
  ProgressKind progress = ProgressKind::automatic;
};

}  // namespace polhode
