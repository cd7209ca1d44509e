// SPDX-License-Identifier: MIT
// Draws charts of drawing settings: time per frame against the error of the picture.
#pragma once

#include <string>
#include <vector>

#include "chart/gnuplot.h"

namespace polhode {

// One measured drawing setting.
struct PicturePoint {
  std::string setting;
  int samples = 0;           // OpenGL samples per drawn pixel; 0: one, without multisampling
  int supersampling = 1;     // drawn width over finished width
  double time_ms = 0.0;      // per frame, drawing and downsampling
  double rmse_levels = 0.0;  // root mean square difference from the best picture, levels of 0..255
  int max_levels = 0;        // largest difference of a channel
};

// The points of one scene.
struct PicturePanel {
  std::string scene;
  std::string title;
  std::vector<PicturePoint> points;
};

// The bytes of a picture file with one panel per scene: error against time per frame, every point
// labelled. Throws Error (environment) as draw_with_gnuplot does.
std::string plot_picture_error(const std::vector<PicturePanel>& panels, PlotFormat format);

// The points as CSV: scene,setting,samples,supersampling,time_ms,rmse_levels,max_levels.
std::string picture_error_csv(const std::vector<PicturePanel>& panels);

}  // namespace polhode
