// SPDX-License-Identifier: MIT
// The command `chart --pictures`: the difference of pictures from heavily supersampled ones against
// the time to draw them, for each drawing setting: without anti-aliasing, with samples, with
// outlines, or drawn larger and averaged.
#pragma once

#include <string>

#include "app/commands/chart.h"

namespace polhode {

// Writes chart.csv, with the columns of picture_error_csv() (chart/plot_picture_error.h),
// chart.svg, chart.png and chart.pdf into the folder of the job, together at the end. job.methods
// is not used. Draws on the calling thread, with an OpenGL context of its own. Each scene is drawn
// at five times of its motion; the reference pictures are averages over 8x8 drawn pixels with four
// samples each. A scene whose pictures have more pixels than 960x540 is drawn smaller, unless the
// job sets the size. Returns a summary, one line per scene and setting. Throws Error (input) with
// --size as key if the job asks for more pixels, and as load_single, solve
// (film/solved_scene.h) and OutputFolder (base/system/output_folder.h) do; (environment) without
// OpenGL or gnuplot or if a file cannot be written; (check_failed) as solve does; (interrupted).
std::string chart_pictures(const ChartJob& job);

}  // namespace polhode
