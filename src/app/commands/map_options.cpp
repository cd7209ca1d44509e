// SPDX-License-Identifier: MIT
#include "app/commands/map_options.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

constexpr int kMostCells = 1024;  // in one direction

MapAxis parse_range(const std::string& text, const std::string& option) {
  MapAxis axis;
  const std::size_t colon = text.find(':');
  const auto number = [&](const std::string& part) {
    const std::optional<double> value = parse_number(part);
    if (!value) {
      throw input_error("'{}' is not a range; write two numbers, 0.1:10", text).at({{}, 0, option});
    }
    return *value;
  };
  if (colon == std::string::npos) number("");
  axis.from = number(text.substr(0, colon));
  axis.to = number(text.substr(colon + 1));
  if (axis.from >= axis.to) {
    throw input_error("the range must go up, got {}", text).at({{}, 0, option});
  }
  if (!std::isfinite(axis.logarithmic() ? axis.to / axis.from : axis.to - axis.from)) {
    throw input_error("{} spans more than numbers hold", text).at({{}, 0, option});
  }
  return axis;
}

}  // namespace

CellCount parse_cells(const std::string& text) {
  int columns = 0, rows = 0, used = 0;
  if (std::sscanf(text.c_str(), "%4dx%4d%n", &columns, &rows, &used) != 2 ||
      used != static_cast<int>(text.size()) || columns < 2 || rows < 2 || columns > kMostCells ||
      rows > kMostCells) {
    throw input_error(
        "'{}' is not the size of a map; write 64x64; each number is at least 2 and at most {}",
        text,
        kMostCells)
        .at({{}, 0, "--cells"});
  }
  return {columns, rows};
}

bool alike_but_for_rounding(double a, double b) {
  constexpr double kRelative = 1e-5, kRounding = 1e-12;
  return a == b || (std::isnan(a) && std::isnan(b)) ||
         std::abs(a - b) <= kRelative * std::max(std::abs(a), std::abs(b)) + kRounding;
}

bool changes_motion(const std::string& key) {
  const bool of_motion = key.starts_with("body.") || key.starts_with("motion.");
  return of_motion && !key.starts_with("motion.duration");
}

std::vector<std::string> idle_axes(const MapAxis& x,
                                   const MapAxis& y,
                                   const std::function<bool(std::size_t a, std::size_t b)>& alike) {
  const auto columns = static_cast<std::size_t>(x.cells), rows = static_cast<std::size_t>(y.cells);
  bool idle_x = true, idle_y = true;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t cell = row * columns + column;
      idle_x = idle_x && alike(cell, row * columns);
      idle_y = idle_y && alike(cell, column);
    }
  }
  std::vector<std::string> found;
  const auto tell = [&](const MapAxis& axis, const char* option) {
    found.push_back(fmt::format(
        "{} {}: changes nothing: all its values have the same results", option, axis.key));
  };
  if (idle_x) tell(x, "--x");
  if (idle_y) tell(y, "--y");
  return found;
}

MapAxis axis_of_key(const std::filesystem::path& file,
                    const std::vector<Setting>& settings,
                    const std::string& key,
                    const std::optional<std::string>& range,
                    const std::string& option) {
  MapAxis axis;
  if (range) {
    axis = parse_range(*range, option + "-range");
  } else {
    const std::optional<double> own = number_in_scene(file, settings, key);
    if (!own) {
      throw input_error("{} has no number at '{}'; give {}-range A:B", file.string(), key, option)
          .at({{}, 0, option});
    }
    axis.from = *own > 0.0 ? *own / 10.0 : *own < 0.0 ? 2.0 * *own : -1.0;
    axis.to = *own > 0.0 ? 10.0 * *own : *own < 0.0 ? -2.0 * *own : 1.0;
  }
  axis.key = key;
  return axis;
}

}  // namespace polhode
