// SPDX-License-Identifier: MIT
// One plot by itself, for handouts: curves and marked points in a plane.
#pragma once

#include <string>
#include <vector>

#include "chart/gnuplot.h"
#include "math/notation.h"

namespace polhode {

// A curve of a sheet, in units of its axes; it is interrupted where a coordinate is not finite.
struct SheetCurve {
  std::string name;   // empty: not in the key; of several with one name, the first is in the key
  std::string color;  // "#rrggbb"
  double width = 2.0;
  std::vector<Vec2> points;
};

// A marked point; `filled`: a disc, else a circle.
struct SheetMark {
  std::string name;
  Vec2 at;
  bool filled = true;
  std::string color = "#000000";
};

// An axis from low to high; low == high: as long as the curves need.
struct SheetAxis {
  std::string label;
  double low = 0.0, high = 0.0;
};

// What a sheet shows. All text is plain.
struct PlotSheet {
  std::string title;
  SheetAxis across, up;
  std::vector<SheetCurve> curves;
  std::vector<SheetMark> marks;
};

// The bytes of a picture file. Throws Error as draw_with_gnuplot() does.
std::string draw_sheet(const PlotSheet& sheet, PlotFormat format);

// The points as a table: curve,x,y with 17 digits; marks are curves of one point. Further curves of
// one name are "name 2", "name 3"; those without a name are "other 1", "other 2". A curve without a
// finite point is left out.
std::string sheet_csv(const PlotSheet& sheet);

}  // namespace polhode
