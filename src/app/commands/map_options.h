// SPDX-License-Identifier: MIT
// What the options --x, --y, --x-range, --y-range and --cells of maps mean.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "chart/map_axis.h"
#include "scene/setting.h"

namespace polhode {

struct CellCount {
  int columns = 0, rows = 0;
};
// "128x96": each from 2 to 1024. Throws Error (input), naming --cells.
CellCount parse_cells(const std::string& text);

// Whether the motion, however long it is shown, depends on a key: those of [body] and [motion] but
// for motion.duration.
bool changes_motion(const std::string& key);

// Whether two numbers of results differ by no more than rounding makes of a motion.
bool alike_but_for_rounding(double a, double b);
// Warnings of axes whose values all have the same results. alike: whether two cells have the same
// result; cells are numbered from 0, row by row, a row being all values of x.
std::vector<std::string> idle_axes(const MapAxis& x,
                                   const MapAxis& y,
                                   const std::function<bool(std::size_t a, std::size_t b)>& alike);

// The axis of a key: its range is "A:B" with A < B or, if none is given, around the number that the
// scene has there: a tenth of it to ten times as much; if it is negative (v), 2 v to -2 v; if it is
// 0, -1 to 1. `option` is "--x" or "--y". Throws Error (input), naming the option of the range, for
// a wrong range and, naming `option`, for a scene without a number there.
MapAxis axis_of_key(const std::filesystem::path& file,
                    const std::vector<Setting>& settings,
                    const std::string& key,
                    const std::optional<std::string>& range,
                    const std::string& option);

}  // namespace polhode
