// SPDX-License-Identifier: MIT
// The use case `chart`: speed against accuracy of the methods that can take a scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/system/progress.h"
#include "film/overrides.h"

namespace polhode {

struct ChartJob {
  std::vector<std::filesystem::path> scenes;
  std::string output;   // folder, made when it is missing
  std::string methods;  // names with commas between; empty: all that can take the scene
  Overrides overrides;
  ProgressKind progress = ProgressKind::automatic;
};

// Writes chart.csv, chart.svg, chart.png and chart.pdf into the folder; all or none of them.
// Returns what a person wants to know first, a few lines. Throws Error.
std::string chart(const ChartJob& job);

}  // namespace polhode
