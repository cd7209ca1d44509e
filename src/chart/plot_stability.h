// SPDX-License-Identifier: MIT
// Draws stability maps: which outcome the runs of a method have, over two parameters.
#pragma once

#include <string>
#include <vector>

#include "chart/gnuplot.h"
#include "chart/map_axis.h"
#include "chart/stability.h"

namespace polhode {

// A point of a limit curve; x and y are values of the axes, in their units.
struct LimitPoint {
  double x = 0.0, y = 0.0;
};

// The map of one method on one scene. The cell in column i and row j, both from 0, is cells[j *
// x.cells + i]; it was run with the values x.at(i) and y.at(j).
struct StabilityMap {
  std::string scene;              // short name, for the CSV table
  std::string title;              // of the picture; plain text
  std::string method;             // StepperInfo::name
  std::string limit_words;        // StepperInfo::limit: the method's step limit as text, or empty
  std::vector<LimitPoint> limit;  // that limit as a curve; empty: none is drawn
  std::vector<StabilityCell> cells;
};

// The bytes of a picture file with one map, or with several in a grid: a colour per outcome, and
// the limit as a dashed curve. With several maps, the title of the first is the heading of the
// grid, and each panel is named by its method. At least one map, none null; all share the axes.
// Thread-safe. Throws Error (environment) and (interrupted) as draw_with_gnuplot does.
std::string plot_stability(const std::vector<const StabilityMap*>& maps,
                           const MapAxis& x,
                           const MapAxis& y,
                           PlotFormat format);

// The cells as CSV, one row each, with the header
// scene,method,x,y,verdict,error_rad,energy_drift,momentum_drift. The verdict is name_of(outcome);
// unknown numbers are "nan".
std::string stability_csv(const std::vector<StabilityMap>& maps,
                          const MapAxis& x,
                          const MapAxis& y);

}  // namespace polhode
