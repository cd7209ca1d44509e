// SPDX-License-Identifier: MIT
// Pictures of what methods cost and how wrong they are.
#pragma once

#include <string>
#include <vector>

#include "chart/gnuplot.h"
#include "chart/work_precision.h"

namespace polhode {

// A scene and its points, as the chart shows them: a row of two panels.
struct WorkPanel {
  std::string scene;  // its short name, for the table
  std::string title;
  std::string reference;      // how the reference solution is known
  double accuracy_rad = 0.0;  // what the scene needs
  std::string accuracy_why;   // "0.1 px of the picture"
  std::vector<WorkPoint> points;
};

// Error over time and error over evaluations, log-log: a colour and a mark per method, the cheapest
// at each accuracy named, what the scene needs as a line. The bytes of a file.
std::string plot_work_precision(const std::vector<WorkPanel>& panels, PlotFormat format);

// The table behind it: scene,method,order,step,evaluations,time_us,error_rad,energy_drift,
// momentum_drift,status.
std::string work_precision_csv(const std::vector<WorkPanel>& panels);

}  // namespace polhode
