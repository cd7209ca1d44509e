// SPDX-License-Identifier: MIT
// Draws work-precision diagrams: the error of methods against their cost.
#pragma once

#include <string>
#include <vector>

#include "chart/gnuplot.h"
#include "chart/work_precision.h"

namespace polhode {

// A scene and its points; the chart shows it as a row of two panels.
struct WorkPanel {
  std::string scene;              // short name, for the CSV table
  std::string title;              // of the row; plain text
  std::string reference;          // ReferenceSolution::source()
  double accuracy_rad = 0.0;      // attitude error that the scene allows
  std::string accuracy_why;       // numerics.accuracy as text: "0.1 px", or "accuracy" for radians
  bool free_body = false;         // nothing turns it
  std::vector<WorkPoint> points;  // grouped by method
};

// The bytes of a picture file: for each scene (at least one) the largest attitude error (vertical)
// against computing time, and beside it against evaluations, all logarithmic. Each family of
// methods has a colour, each method in it a mark, and a dashed line shows the allowed error. Of the
// errors 1, 0.1, 0.01 rad and so on, the method that reaches each at the least cost is labelled
// wherever it changes. Only points with the status "ok" and errors up to 10 rad are drawn; words
// tell which methods are exact on a free body. A scene without any point gets one panel that says
// so. Thread-safe. Throws Error (environment) and (interrupted) as draw_with_gnuplot does.
std::string plot_work_precision(const std::vector<WorkPanel>& panels, PlotFormat format);
// What gnuplot is given for it, for tests.
std::string work_precision_script(const std::vector<WorkPanel>& panels);

// The points as CSV, one row each, with the header
// scene,method,order,step,evaluations,time_us,error_rad,energy_drift,momentum_drift,status (see
// WorkPoint). Unknown numbers are "nan".
std::string work_precision_csv(const std::vector<WorkPanel>& panels);

}  // namespace polhode
