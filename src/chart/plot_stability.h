// SPDX-License-Identifier: MIT
// Maps of where methods fail.
#pragma once

#include <string>
#include <vector>

#include "chart/gnuplot.h"
#include "chart/stability.h"

namespace polhode {

// One direction of a map: a key of the scene and the values that it takes.
struct MapAxis {
  std::string key;
  double from = 0.1, to = 10.0;
  int cells = 64;

  // equal ratios when both ends are positive, else equal differences
  bool logarithmic() const { return from > 0.0 && to > 0.0; }
  double at(int i) const;
};

struct LimitPoint {
  double x = 0.0, y = 0.0;
};

// The map of one method: cells in rows of equal y, from the first x and y on.
struct StabilityMap {
  std::string scene;
  std::string title;
  std::string method;
  std::string limit_words;        // what theory says of the method
  std::vector<LimitPoint> limit;  // the curve that it gives; empty where it gives none
  std::vector<StabilityCell> cells;
};

// The picture of one map, or of many in a grid; the bytes of a file.
std::string plot_stability(const std::vector<const StabilityMap*>& maps,
                           const MapAxis& x,
                           const MapAxis& y,
                           PlotFormat format);

// scene,method,x,y,verdict,error_rad,energy_drift,momentum_drift
std::string stability_csv(const std::vector<StabilityMap>& maps,
                          const MapAxis& x,
                          const MapAxis& y);

}  // namespace polhode
