// SPDX-License-Identifier: MIT
#include "chart/map_axis.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "chart/gnuplot.h"

namespace polhode {
namespace {

std::string range_and_label(const char* letter, const std::string& label, double low, double high) {
  return fmt::format("set {}range [{}:{}]\nset {}label {}\n",
                     letter,
                     gnuplot_number(low),
                     gnuplot_number(high),
                     letter,
                     gnuplot_text(label));
}

}  // namespace

double MapAxis::at(int i) const {
  if (cells == 1) return from;
  const double part = static_cast<double>(i) / (cells - 1);
  return logarithmic() ? from * std::pow(to / from, part) : from + part * (to - from);
}

double shown_on(const MapAxis& axis, double value) {
  return axis.logarithmic() ? std::log10(value) : value;
}

std::string logarithmic_axis_script(
    const char* letter, const std::string& label, double low, double high, bool crowded) {
  std::string tics;
  for (int power = static_cast<int>(std::floor(low)); power <= static_cast<int>(high) + 1;
       ++power) {
    for (const int digit : {1, 2, 5}) {
      if (crowded && digit != 1) continue;
      const double place = power + std::log10(static_cast<double>(digit));
      if (place < low || place > high) continue;
      tics += fmt::format("{}'{:g}' {}",
                          tics.empty() ? "" : ", ",
                          digit * std::pow(10.0, power),
                          gnuplot_number(place));
    }
  }
  return range_and_label(letter, label, low, high) + fmt::format("set {}tics ({})\n", letter, tics);
}

std::string axis_script(const char* letter, const MapAxis& axis, bool alone) {
  const double first = shown_on(axis, axis.at(0)), last = shown_on(axis, axis.at(axis.cells - 1));
  const double half = 0.5 * (last - first) / std::max(1, axis.cells - 1);
  const std::string label = axis.key == "spin" ? "spin / the scene's" : axis.key;
  if (axis.logarithmic()) {
    const bool crowded = !alone && last - first >= 1.0;
    return logarithmic_axis_script(letter, label, first - half, last + half, crowded);
  }
  return range_and_label(letter, label, first - half, last + half) +
         fmt::format("set {}tics auto\n", letter);
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
