// SPDX-License-Identifier: MIT
// The command `chart --pictures`: the difference of pictures from heavily supersampled ones against
// the time to draw them, for each drawing setting.
#pragma once

#include <string>

#include "app/commands/chart.h"

namespace polhode {

// Writes chart.csv, with the columns of picture_error_csv(), chart.svg, chart.png and chart.pdf
// into the folder of the job, together at the end. job.methods is not used. Draws on the calling
// thread, with an OpenGL context of its own. Returns a summary, one line per setting and scene.
// Throws Error (input) with --size as key for a given size of more than 960x540 pixels, as
// load_with_overrides, solve and OutputFolder do; (environment) without OpenGL or gnuplot;
// (interrupted).
std::string chart_pictures(const ChartJob& job);

}  // namespace polhode
