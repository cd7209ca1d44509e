// SPDX-License-Identifier: MIT
// Maps of Lyapunov exponents: where, over two keys of a scene, its motion is chaotic.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "chart/gnuplot.h"
#include "chart/map_axis.h"
#include "chart/section.h"

namespace polhode {

struct ExponentCell {
  SectionVerdict verdict = SectionVerdict::undecided;
  double exponent = 0.0;  // 1/s, SectionOrbit::exponent()
  int crossings = 0;      // found of those that were asked for
};

struct ExponentMap {
  std::string title;
  MapAxis x, y;
  std::vector<ExponentCell> cells;  // row by row

  // Both count from 0.
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(x.cells) +
           static_cast<std::size_t>(column);
  }
  const ExponentCell& at(int column, int row) const { return cells[index(column, row)]; }
  ExponentCell& at(int column, int row) { return cells[index(column, row)]; }
};

// The bytes of a picture: a colour for the exponent of chaotic motions, pale green for regular
// ones, grey for undecided ones. Throws Error as draw_with_gnuplot() does.
std::string plot_exponents(const ExponentMap& map, PlotFormat format);
// What gnuplot is given for it, for tests.
std::string exponents_script(const ExponentMap& map);

// One row per cell: x, y, verdict, exponent_per_s, crossings.
std::string exponents_csv(const ExponentMap& map);

}  // namespace polhode
