// SPDX-License-Identifier: MIT
#include "chart/plot_exponents.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace polhode {
namespace {

constexpr int kMapWidth = 1000, kMapHeight = 700;
constexpr const char* kRegularColor = "#E8F1E4";
constexpr const char* kUndecidedColor = "#9AA5B1";
// of exponents, from the least to the greatest
constexpr const char* kExponentColors[] = {"#FEE391", "#FB8D3C", "#C51B1B", "#4A0012"};

double greatest_exponent(const ExponentMap& map) {
  double greatest = 0.0;
  for (const ExponentCell& cell : map.cells) {
    if (cell.verdict == SectionVerdict::chaotic) greatest = std::max(greatest, cell.exponent);
  }
  return greatest;
}

// 1, 2 or 5 times a power of ten, three to seven times in `range`
double round_step(double range) {
  const double power = std::pow(10.0, std::floor(std::log10(range / 3.0)));
  const double times = range / 3.0 / power;
  return power * (times < 2.0 ? 1.0 : times < 5.0 ? 2.0 : 5.0);
}

}  // namespace

std::string exponents_script(const ExponentMap& map) {
  const double greatest = greatest_exponent(map);
  const bool any = greatest > 0.0;
  // below 0 there are two bands of this height for what has no exponent
  const double band = any ? greatest / 12.0 : 1.0;
  std::string script = "$cells << EOD\n";
  const auto columns = static_cast<std::size_t>(map.x.cells);
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const ExponentCell& cell = map.cells[i];
    const double value = cell.verdict == SectionVerdict::chaotic     ? cell.exponent
                         : cell.verdict == SectionVerdict::undecided ? -0.5 * band
                                                                     : -1.5 * band;
    script += gnuplot_number(value) + ((i + 1) % columns == 0 ? '\n' : ' ');
  }
  script += "EOD\n";
  const auto at = [](double value) {
    return gnuplot_number(value);
  };
  script +=
      fmt::format("set palette maxcolors 0 defined ({0} '{3}', {1} '{3}', {1} '{4}', {2} '{4}'",
                  at(-2.0 * band),
                  at(-band),
                  at(0.0),
                  kRegularColor,
                  kUndecidedColor);
  std::string tics = fmt::format("'regular' {}, 'undecided' {}", at(-1.5 * band), at(-0.5 * band));
  if (any) {
    constexpr std::size_t kColors = std::size(kExponentColors);
    for (std::size_t i = 0; i < kColors; ++i) {
      const double value = greatest * static_cast<double>(i) / (kColors - 1);
      script += fmt::format(", {} '{}'", at(value), kExponentColors[i]);
    }
    const double step = round_step(greatest);
    for (double value = step; value <= greatest; value += step)
      tics += fmt::format(", '{:.3g}' {}", value, at(value));
  }
  // the words beside the colours need room
  script += ")\nset rmargin at screen 0.78\n";
  script += fmt::format("set cbrange [{}:{}]\nset cbtics ({})\nset cblabel {}\n",
                        at(-2.0 * band),
                        at(greatest),
                        tics,
                        gnuplot_text(any ? "largest Lyapunov exponent, 1/s" : ""));
  script += "unset key\nset title " + gnuplot_text(map.title) + "\n";
  script += axis_script("x", map.x, true) + axis_script("y", map.y, true);
  return script +
         fmt::format("plot $cells matrix using {}:3 with image\n", cells_using(map.x, map.y));
}

std::string plot_exponents(const ExponentMap& map, PlotFormat format) {
  return draw_with_gnuplot(exponents_script(map), format, kMapWidth, kMapHeight);
}

std::string exponents_csv(const ExponentMap& map) {
  std::string text = "x,y,verdict,exponent_per_s,crossings\n";
  for (int row = 0; row < map.y.cells; ++row) {
    for (int column = 0; column < map.x.cells; ++column) {
      const ExponentCell& cell = map.at(column, row);
      text += fmt::format("{},{},{},{:.6g},{}\n",
                          map.x.at(column),
                          map.y.at(row),
                          name_of(cell.verdict),
                          cell.exponent,
                          cell.crossings);
    }
  }
  return text;
}

}  // namespace polhode
