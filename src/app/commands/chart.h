// SPDX-License-Identifier: MIT
// The command `chart`: accuracy against cost of the methods on one or more scenes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/system/progress.h"
#include "film/overrides.h"

namespace polhode {

// The options of `chart`.
struct ChartJob {
  std::vector<std::filesystem::path> scenes;
  std::string output;   // folder, created if needed
  std::string methods;  // comma-separated names; empty: all that can integrate the scene
  Overrides overrides;
  ProgressKind progress = ProgressKind::automatic;
};

// Writes chart.csv, chart.svg, chart.png and chart.pdf into the folder, all or none of them.
// Returns a summary of a few lines. Throws Error (input) naming --methods for a method that cannot
// integrate a scene, and as load_with_overrides and OutputFolder do; (environment) without gnuplot;
// (interrupted).
std::string chart(const ChartJob& job);

}  // namespace polhode
