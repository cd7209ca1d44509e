// SPDX-License-Identifier: MIT
// Draws stability maps: which outcome the runs of a method have, over two parameters.
#pragma once

#include <string>
#include <vector>

#include "chart/gnuplot.h"
#include "chart/stability.h"

namespace polhode {

// One axis of a map: a key of the scene and its values, in the unit in which the scene spells the
// key.
struct MapAxis {
  std::string key;
  double from = 0.1, to = 10.0;
  int cells = 64;

  // True if the values have equal ratios (both ends positive); else they have equal differences.
  bool logarithmic() const { return from > 0.0 && to > 0.0; }
  // The value of cell i, 0 <= i < cells.
  double at(int i) const;
};

// A point of a limit curve, in the values of the axes.
struct LimitPoint {
  double x = 0.0, y = 0.0;
};

// The map of one method. Cell (column i, row j) is cells[j * x.cells + i].
struct StabilityMap {
  std::string scene;
  std::string title;
  std::string method;
  std::string limit_words;        // the method's step limit, as text
  std::vector<LimitPoint> limit;  // the limit as a curve; empty: theory gives none
  std::vector<StabilityCell> cells;
};

// The bytes of a picture file with one map, or with several in a grid. All maps share the axes.
// Throws Error (environment) as draw_with_gnuplot does.
std::string plot_stability(const std::vector<const StabilityMap*>& maps,
                           const MapAxis& x,
                           const MapAxis& y,
                           PlotFormat format);

// The cells as CSV: scene,method,x,y,verdict,error_rad,energy_drift,momentum_drift. The verdict is
// name_of() the outcome.
std::string stability_csv(const std::vector<StabilityMap>& maps,
                          const MapAxis& x,
                          const MapAxis& y);

}  // namespace polhode
