// SPDX-License-Identifier: MIT
// The axes of maps over two keys of a scene, and how gnuplot draws them.
#pragma once

#include <string>

namespace polhode {

// One axis of a map: a key of the scene and the values that the cells give it, in the unit in which
// the scene spells the key. The key "spin" is a factor on the angular momentum at the start
// (app/commands/stability_job.h).
struct MapAxis {
  std::string key;               // dotted path such as "numerics.step", or "spin"
  double from = 0.1, to = 10.0;  // values of the first and the last cell; from < to
  int cells = 64;                // number of cells along the axis, at least 1

  // True if neighbouring values have equal ratios, which is so if both ends are positive; else they
  // have equal differences.
  bool logarithmic() const { return from > 0.0 && to > 0.0; }
  // The value of cell i, 0 <= i < cells; `from` if there is only one.
  double at(int i) const;
};

// Where gnuplot, which is not told of logarithms here, draws a value of the axis.
double shown_on(const MapAxis& axis, double value);
// Range, label and tics of the axis "x" or "y" whose values are drawn at their logarithms to base
// 10, from `low` to `high`: 1, 2, 5 of every power of ten inside, or if it is crowded the powers
// alone.
std::string logarithmic_axis_script(
    const char* letter, const std::string& label, double low, double high, bool crowded = false);
// The same of an axis of a map, which begins and ends with half a cell; a map that is not alone has
// few tics.
std::string axis_script(const char* letter, const MapAxis& axis, bool alone);
// The places of the cells of a matrix, as the first two columns after `using`.
std::string cells_using(const MapAxis& x, const MapAxis& y);

}  // namespace polhode
