// SPDX-License-Identifier: MIT
// The command `plot`: draws a quantity over time or a diagram by itself, for handouts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "film/overrides.h"

namespace polhode {

// The options of `plot`.
struct PlotJob {
  std::filesystem::path scene;
  std::string name;          // one of plot_names() (motion/diagram.h)
  std::string output;        // a .svg, .png, .pdf or .csv
  std::optional<double> at;  // s of motion whose point is marked in a diagram; absent: none
  Overrides overrides;
};

// Writes the file. Throws Error as load_single and solve (film/solved_scene.h) do; (input) with
// PLOT as key for an unknown name or a diagram that the motion does not have, with --at for a time
// outside the motion or for a quantity over time, and for an output that is the scene, has another
// ending or cannot be written; (environment) if gnuplot is missing or writing fails; (interrupted).
void draw_plot(const PlotJob& job);

}  // namespace polhode
