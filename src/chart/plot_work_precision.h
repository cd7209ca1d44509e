// SPDX-License-Identifier: MIT
// Draws work-precision diagrams: the error of methods against their cost.
#pragma once

#include <string>
#include <vector>

#include "chart/gnuplot.h"
#include "chart/work_precision.h"

namespace polhode {

// A scene and its points: one row of two panels.
struct WorkPanel {
  std::string scene;  // short name, for the CSV table
  std::string title;
  std::string reference;      // ReferenceSolution::source()
  double accuracy_rad = 0.0;  // attitude error that the scene allows
  std::string accuracy_why;   // where that comes from, such as "0.1 px of the picture"
  std::vector<WorkPoint> points;
};

// The bytes of a picture file: error against computing time and error over evaluations, log-log.
// Each method has a colour and a symbol, the cheapest at each accuracy is labelled, and a line
// shows the allowed error. Throws Error (environment) as draw_with_gnuplot does.
std::string plot_work_precision(const std::vector<WorkPanel>& panels, PlotFormat format);

// The points as CSV: scene,method,order,step,evaluations,time_us,error_rad,energy_drift,
// momentum_drift,status.
std::string work_precision_csv(const std::vector<WorkPanel>& panels);

}  // namespace polhode
