// SPDX-License-Identifier: MIT
#include "chart/map_axis.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "chart/gnuplot.h"

namespace polhode {

double MapAxis::at(int i) const {
  if (cells == 1) return from;
  const double part = static_cast<double>(i) / (cells - 1);
  return logarithmic() ? from * std::pow(to / from, part) : from + part * (to - from);
}

double shown_on(const MapAxis& axis, double value) {
  return axis.logarithmic() ? std::log10(value) : value;
}

std::string axis_script(const char* letter, const MapAxis& axis, bool alone) {
  const double first = shown_on(axis, axis.at(0)), last = shown_on(axis, axis.at(axis.cells - 1));
  const double half = 0.5 * (last - first) / std::max(1, axis.cells - 1);
  std::string text =
      fmt::format("set {}range [{}:{}]\nset {}label {}\n",
                  letter,
                  gnuplot_number(first - half),
                  gnuplot_number(last + half),
                  letter,
                  gnuplot_text(axis.key == "spin" ? "spin / the scene's" : axis.key));
  if (!axis.logarithmic()) return text + fmt::format("set {}tics auto\n", letter);
  // 1, 2, 5 of every power of ten inside; in a small panel the powers alone, if there are two
  const bool crowded = !alone && last - first >= 1.0;
  std::string tics;
  for (int power = static_cast<int>(std::floor(first)); power <= static_cast<int>(last) + 1;
       ++power) {
    for (const int digit : {1, 2, 5}) {
      if (crowded && digit != 1) continue;
      const double place = power + std::log10(static_cast<double>(digit));
      if (place < first - half || place > last + half) continue;
      tics += fmt::format("{}'{:g}' {}",
                          tics.empty() ? "" : ", ",
                          digit * std::pow(10.0, power),
                          gnuplot_number(place));
    }
  }
  return text + fmt::format("set {}tics ({})\n", letter, tics);
}

std::string cells_using(const MapAxis& x, const MapAxis& y) {
  const auto first_and_step = [](const MapAxis& axis) {
    const double first = shown_on(axis, axis.at(0));
    const double last = shown_on(axis, axis.at(axis.cells - 1));
    return std::pair(gnuplot_number(first),
                     gnuplot_number((last - first) / std::max(1, axis.cells - 1)));
  };
  const auto [x0, dx] = first_and_step(x);
  const auto [y0, dy] = first_and_step(y);
  return fmt::format("({}+$1*{}):({}+$2*{})", x0, dx, y0, dy);
}

}  // namespace polhode
