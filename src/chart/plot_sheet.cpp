// SPDX-License-Identifier: MIT
#include "chart/plot_sheet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "base/csv.h"

namespace polhode {
namespace {

constexpr int kSheetWidth = 720, kSheetHeight = 480;

std::string range_of(const SheetAxis& axis) {
  if (axis.low == axis.high) return "[*:*]";
  return fmt::format("[{}:{}]", gnuplot_number(axis.low), gnuplot_number(axis.high));
}

}  // namespace

std::string draw_sheet(const PlotSheet& sheet, PlotFormat format) {
  std::string script = fmt::format(
      "set grid linecolor rgb '#dddddd' linewidth 0.5\n"
      "set key outside right top vertical Left reverse noenhanced\n"
      "set title {}\nset xlabel {}\nset ylabel {}\nset xrange {}\nset yrange {}\n",
      gnuplot_text(sheet.title),
      gnuplot_text(sheet.across.label),
      gnuplot_text(sheet.up.label),
      range_of(sheet.across),
      range_of(sheet.up));
  std::string plots;
  const auto add = [&](const std::string& what) {
    plots += (plots.empty() ? "plot " : ", ") + what;
  };
  std::set<std::string> in_key;
  for (std::size_t i = 0; i < sheet.curves.size(); ++i) {
    const SheetCurve& curve = sheet.curves[i];
    const bool is_new = !curve.name.empty() && in_key.insert(curve.name).second;
    script += fmt::format("$curve{} << EOD\n", i);
    for (const Vec2& point : curve.points) {
      // a line without numbers interrupts the curve
      script += point.allFinite()
                    ? fmt::format("{} {}\n", gnuplot_number(point.x()), gnuplot_number(point.y()))
                    : "\n";
    }
    script += "EOD\n";
    add(fmt::format("$curve{} using 1:2 with lines linewidth {} linecolor rgb '{}' {}",
                    i,
                    curve.width,
                    curve.color,
                    is_new ? "title " + gnuplot_text(curve.name) : "notitle"));
  }
  for (std::size_t i = 0; i < sheet.marks.size(); ++i) {
    const SheetMark& mark = sheet.marks[i];
    script += fmt::format("$mark{} << EOD\n{} {}\nEOD\n",
                          i,
                          gnuplot_number(mark.at.x()),
                          gnuplot_number(mark.at.y()));
    // a circle hides the curves behind it
    if (!mark.filled) {
      add(
          fmt::format("$mark{} using 1:2 with points pointtype 7 pointsize 1.2 "
                      "linecolor rgb '#ffffff' notitle",
                      i));
    }
    add(
        fmt::format("$mark{} using 1:2 with points pointtype {} pointsize 1.2 linewidth 2 "
                    "linecolor rgb '{}' notitle",
                    i,
                    mark.filled ? 7 : 6,
                    mark.color));
    if (mark.name.empty()) continue;
    script += fmt::format("set label {} at {},{} offset 0.8,0.8\n",
                          gnuplot_text(mark.name),
                          gnuplot_number(mark.at.x()),
                          gnuplot_number(mark.at.y()));
  }
  return draw_with_gnuplot(script + plots + "\n", format, kSheetWidth, kSheetHeight);
}

std::string sheet_csv(const PlotSheet& sheet) {
  std::string text = "curve,x,y\n";
  const auto add = [&](const std::string& name, const Vec2& point) {
    text += fmt::format("{},{:.17g},{:.17g}\n", csv_field(name), point.x() + 0.0, point.y() + 0.0);
  };
  std::map<std::string, int> of_name;
  for (const SheetCurve& curve : sheet.curves) {
    // such as the drift of what the motion does not keep
    const bool is_anywhere = std::any_of(curve.points.begin(),
                                         curve.points.end(),
                                         [](const Vec2& point) { return point.allFinite(); });
    if (!is_anywhere) continue;
    const int number = ++of_name[curve.name];
    const std::string name = curve.name.empty() ? fmt::format("other {}", number)
                             : number == 1      ? curve.name
                                                : fmt::format("{} {}", curve.name, number);
    for (const Vec2& point : curve.points)
      add(name, point);
  }
  for (const SheetMark& mark : sheet.marks)
    add(mark.name.empty() ? "mark" : mark.name, mark.at);
  return text;
}

}  // namespace polhode
