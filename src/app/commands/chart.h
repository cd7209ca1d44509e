// SPDX-License-Identifier: MIT
// The command `chart`: error against cost of the integration methods on one or more scenes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/system/progress.h"
#include "film/overrides.h"

namespace polhode {

// The options of `chart`.
struct ChartJob {
  std::vector<std::filesystem::path> scenes;  // at least one
  std::string output;   // folder, created if needed; empty: output/SCENE_chart of the first scene
  std::string methods;  // names, separated by commas; empty: all that can integrate the scene
  // All are applied. The command line sets accuracy, and size for chart_pictures(), which takes the
  // same job.
  Overrides overrides;
  ProgressKind progress = ProgressKind::automatic;
};

// Writes chart.csv, with the columns of work_precision_csv() (chart/plot_work_precision.h),
// chart.svg, chart.png and chart.pdf into the folder, together at the end. Runs one method at a
// time, because it measures times. Returns a summary of a few lines per scene. Throws Error
// (input) with --methods as key for an unknown method or if none of them can integrate a scene,
// and as load_single, make_model and start_state (motion/motion.h), accuracy_in_radians
// (film/solved_scene.h), work_precision (chart/work_precision.h) and OutputFolder
// (base/system/output_folder.h) do, without a place for two scenes of the same name; (environment)
// without gnuplot or if a file cannot be written; (interrupted).
std::string chart(const ChartJob& job);

}  // namespace polhode
