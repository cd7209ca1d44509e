// SPDX-License-Identifier: MIT
// Draws the charts of `chart --pictures`: error of the picture against time per frame, for
// different drawing settings.
#pragma once

#include <string>
#include <vector>

#include "chart/gnuplot.h"

namespace polhode {

// One measured drawing setting.
struct PicturePoint {
  std::string setting;       // name, for the legend and the CSV table
  int samples = 0;           // OpenGL samples per drawn pixel; 0: one, without multisampling
  int supersampling = 1;     // width of the drawn picture over that of the finished one
  double time_ms = 0.0;      // per frame, positive: composing, drawing and downsampling
  double rmse_levels = 0.0;  // root mean square difference from the best picture, levels of 0..255
  int max_levels = 0;        // largest difference of a value from that picture, levels of 0..255
};

// The points of one scene.
struct PicturePanel {
  std::string scene;  // short name, for the CSV table
  std::string title;  // of the panel; plain text
  std::vector<PicturePoint> points;
};

// The bytes of a picture file with one panel per scene (at least one): RMS error (vertical) against
// time per frame, both logarithmic, with the settings in a legend. Every panel needs at least one
// point; points without error are not drawn. Thread-safe. Throws Error (environment) and
// (interrupted) as draw_with_gnuplot does.
std::string plot_picture_error(const std::vector<PicturePanel>& panels, PlotFormat format);

// The points as CSV, one row each, with the header
// scene,setting,samples,supersampling,time_ms,rmse_levels,max_levels.
std::string picture_error_csv(const std::vector<PicturePanel>& panels);

}  // namespace polhode
