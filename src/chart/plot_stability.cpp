// SPDX-License-Identifier: MIT
#include "chart/plot_stability.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/csv.h"

namespace polhode {
namespace {

// fine is calm, the rest told apart by the colour-blind too: lightness rises along the list
constexpr std::array<const char*, kRunOutcomes> kOutcomeColors = {
    "#E8F1E4", "#9CC3E6", "#0072B2", "#D55E00", "#7B3294", "#E69F00", "#222222", "#BBBBBB"};

// an outcome in the key: its colour and its name
std::string key_entry(int outcome) {
  std::string words = name_of(static_cast<RunOutcome>(outcome));
  std::replace(words.begin(), words.end(), '_', ' ');
  return fmt::format("NaN with points pointtype 5 pointsize 2 linecolor rgb '{}' title {}",
                     kOutcomeColors[static_cast<std::size_t>(outcome)],
                     gnuplot_text(words));
}

// whether a curve comes into the picture
bool is_seen(const std::vector<LimitPoint>& limit, const MapAxis& x) {
  return std::any_of(limit.begin(), limit.end(), [&](const LimitPoint& p) {
    return p.x >= x.from && p.x <= x.to;
  });
}

// one map, alone or in a grid of them
std::string map_script(
    const StabilityMap& map, std::size_t index, const MapAxis& x, const MapAxis& y, bool alone) {
  std::string text = fmt::format("$map{} << EOD\n", index);
  const auto columns = static_cast<std::size_t>(x.cells);
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    text += std::to_string(static_cast<int>(map.cells[i].outcome));
    text += (i + 1) % columns == 0 ? '\n' : ' ';
  }
  text += "EOD\n";
  if (!map.limit.empty()) {
    text += fmt::format("$limit{} << EOD\n", index);
    for (const LimitPoint& p : map.limit) {
      text += fmt::format(
          "{} {}\n", gnuplot_number(shown_on(x, p.x)), gnuplot_number(shown_on(y, p.y)));
    }
    text += "EOD\n";
  }
  text += axis_script("x", x, alone) + axis_script("y", y, alone);
  text += "set title " +
          gnuplot_text(alone ? fmt::format("{}: {}{}{}",
                                           map.title,
                                           map.method,
                                           map.limit_words.empty() ? "" : "; ",
                                           map.limit_words)
                             : map.method) +
          "\n";
  text += fmt::format("plot $map{} matrix using {}:3 with image notitle", index, cells_using(x, y));
  if (!map.limit.empty()) {
    text += fmt::format(
        ", $limit{} using 1:2 with lines linewidth 2 dashtype 2 linecolor rgb 'black' title {}",
        index,
        gnuplot_text(alone && is_seen(map.limit, x) ? "limit of theory" : ""));
  }
  if (alone) {
    for (int v = 0; v < kRunOutcomes; ++v)
      text += ", " + key_entry(v);
  }
  return text + "\n";
}

std::string palette() {
  std::string text;
  for (int v = 0; v < kRunOutcomes; ++v) {
    text += fmt::format(
        "{}{} '{}'", v == 0 ? "" : ", ", v, kOutcomeColors[static_cast<std::size_t>(v)]);
  }
  return fmt::format(
      "set palette maxcolors {} defined ({})\nset cbrange [-0.5:{}]\nunset colorbox\n",
      kRunOutcomes,
      text,
      kRunOutcomes - 0.5);
}

}  // namespace

std::string plot_stability(const std::vector<const StabilityMap*>& maps,
                           const MapAxis& x,
                           const MapAxis& y,
                           PlotFormat format) {
  std::string script = palette() + "set key outside right top vertical Left reverse noenhanced\n";
  if (maps.size() == 1) {
    script += map_script(*maps[0], 0, x, y, true);
    return draw_with_gnuplot(script, format, 1000, 700);
  }
  // a grid; what the colours are stands in a last panel
  constexpr int kMostColumns = 6;
  const int panels = static_cast<int>(maps.size()) + 1;
  const int rows = (panels + kMostColumns - 1) / kMostColumns;
  const int columns = (panels + rows - 1) / rows;
  const int width = 290 * columns, height = 260 * rows;
  script += fmt::format(
      "set multiplot layout {},{} margins screen {:.4f},{:.4f},{:.4f},{:.4f} spacing screen "
      "{:.4f},{:.4f}\nunset key\n",
      rows,
      columns,
      60.0 / width,
      1.0 - 20.0 / width,
      50.0 / height,
      1.0 - 36.0 / height,
      60.0 / width,
      80.0 / height);
  MapAxis unnamed = y;
  unnamed.key.clear();
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const bool begins_row = i % static_cast<std::size_t>(columns) == 0;
    script += map_script(*maps[i], i, x, begins_row ? y : unnamed, false);
  }
  script += fmt::format(
      "set title {}\nset key inside left top\nunset xtics\nunset ytics\nunset border\n"
      "unset xlabel\nunset ylabel\nplot [0:1][0:1] ",
      gnuplot_text(maps[0]->title));
  for (int v = 0; v < kRunOutcomes; ++v)
    script += key_entry(v) + ", ";
  const bool has_limit = std::any_of(
      maps.begin(), maps.end(), [&](const StabilityMap* map) { return is_seen(map->limit, x); });
  script += has_limit ? "NaN with lines dashtype 2 linecolor rgb 'black' title 'limit of theory'\n"
                      : "NaN notitle\n";
  script += "unset multiplot\n";
  return draw_with_gnuplot(script, format, width, height);
}

std::string stability_csv(const std::vector<StabilityMap>& maps,
                          const MapAxis& x,
                          const MapAxis& y) {
  std::string text = "scene,method,x,y,verdict,error_rad,energy_drift,momentum_drift\n";
  for (const StabilityMap& map : maps) {
    for (int row = 0; row < y.cells; ++row) {
      for (int column = 0; column < x.cells; ++column) {
        const StabilityCell& cell =
            map.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(x.cells) +
                      static_cast<std::size_t>(column)];
        fmt::format_to(std::back_inserter(text),
                       "{},{},{},{},{},{:.6g},{:.6g},{:.6g}\n",
                       csv_field(map.scene),
                       map.method,
                       x.at(column),
                       y.at(row),
                       name_of(cell.outcome),
                       cell.error_rad,
                       cell.energy_drift,
                       cell.momentum_drift);
      }
    }
  }
  return text;
}

}  // namespace polhode
