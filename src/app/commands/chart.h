// SPDX-License-Identifier: MIT
// The command `chart`: error against cost of the integration methods on one or more scenes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/divided_work.h"
#include "app/piecewise.h"
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
  PartOptions part;  // not of chart_pictures()
  ProgressKind progress = ProgressKind::automatic;
};

// Writes chart.csv, with the columns of work_precision_csv() (chart/plot_work_precision.h),
// chart.svg, chart.png and chart.pdf into the folder, together at the end. Runs one method at a
// time, because it measures times. If it is interrupted or fails, the points of finished methods
// are kept there in chart.resume for the next run with the same options. With job.part.shard it
// only makes a part, as stability() (app/commands/stability.h) does. Returns a summary of a few
// lines per scene. Throws Error (input) with --methods as key for an unknown method or if none of
// them can integrate a scene, and as load_single, make_model and start_state (motion/motion.h),
// accuracy_in_radians (film/solved_scene.h), work_precision (chart/work_precision.h) and
// OutputFolder (base/system/output_folder.h) do, without a place for two scenes of the same name;
// (environment) without gnuplot or if a file cannot be written; (interrupted).
std::string chart(const ChartJob& job);

// The same work before it is begun. Throws Error as chart() does.
DividedWork divided_chart(const ChartJob& job);

}  // namespace polhode
