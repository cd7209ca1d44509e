// SPDX-License-Identifier: MIT
// Charts of what drawing settings cost and how far their pictures are from the best ones.
#pragma once

#include <string>
#include <vector>

#include "chart/gnuplot.h"

namespace polhode {

struct PicturePoint {
  std::string setting;
  int samples = 0;        // per drawn pixel; 0: one
  int supersampling = 1;  // sides of the drawn picture over those of the finished one
  double time_ms = 0.0;   // of a frame, drawn and averaged
  double rmse_levels = 0.0;
  int max_levels = 0;  // the largest difference of a channel
};

struct PicturePanel {
  std::string scene;
  std::string title;
  std::vector<PicturePoint> points;
};

// One panel per scene: error over time, every point named. The bytes of a file.
std::string plot_picture_error(const std::vector<PicturePanel>& panels, PlotFormat format);

// The table behind it.
std::string picture_error_csv(const std::vector<PicturePanel>& panels);

}  // namespace polhode
