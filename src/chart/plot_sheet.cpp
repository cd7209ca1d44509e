// SPDX-License-Identifier: MIT
#include "chart/plot_sheet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/csv.h"

namespace polhode {
namespace {

constexpr int kSheetWidth = 720, kSheetHeight = 480;

// the least and the greatest coordinate of all that is shown; 0 and 0 of nothing
std::pair<double, double> ends_of(const PlotSheet& sheet, int coordinate) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto see = [&](const Vec2& point) {
    if (!point.allFinite()) return;
    low = std::min(low, point[coordinate]);
    high = std::max(high, point[coordinate]);
  };
  for (const SheetCurve& curve : sheet.curves)
    std::for_each(curve.points.begin(), curve.points.end(), see);
  for (const SheetMark& mark : sheet.marks)
    see(mark.at);
  return low <= high ? std::pair{low, high} : std::pair{0.0, 0.0};
}

// How gnuplot sets an axis, "x" or "y": its range, and its numbers with as many digits as tell them
// apart. What is constant but for round-off gets a range of a thousandth of it.
std::string axis_of(const PlotSheet& sheet, const char* name) {
  constexpr double kRoundOff = 1e-9, kOfConstants = 1e-3, kSmall = 1e-3;
  constexpr int kUsualDigits = 6, kMostDigits = 15, kBetweenTicks = 3;
  const bool is_across = *name == 'x';
  const SheetAxis& axis = is_across ? sheet.across : sheet.up;
  const bool is_free = axis.low == axis.high;
  auto [low, high] = is_free ? ends_of(sheet, is_across ? 0 : 1) : std::pair(axis.low, axis.high);
  const double size = std::max(std::abs(low), std::abs(high));
  const bool is_constant = is_free && size > 0.0 && high - low <= kRoundOff * size;
  if (is_constant) {
    low -= kOfConstants * size;
    high += kOfConstants * size;
  }
  std::string text =
      is_free && !is_constant
          ? fmt::format("set {}range [*:*]\n", name)
          : fmt::format("set {}range [{}:{}]\n", name, gnuplot_number(low), gnuplot_number(high));
  if (!(low < high) || !std::isfinite(high - low)) return text;
  const int needed = static_cast<int>(std::ceil(std::log10(size / (high - low)))) + kBetweenTicks;
  // small numbers have fewer of its own
  if (needed > kUsualDigits || size < kSmall) {
    text +=
        fmt::format("set format {} '%.{}h'\n", name, std::clamp(needed, kUsualDigits, kMostDigits));
  }
  return text;
}

}  // namespace

std::string draw_sheet(const PlotSheet& sheet, PlotFormat format) {
  std::string script = fmt::format(
      "set grid linecolor rgb '#dddddd' linewidth 0.5\n"
      "set key outside right top vertical Left reverse noenhanced\n"
      "set title {}\nset xlabel {}\nset ylabel {}\n{}{}",
      gnuplot_text(sheet.title),
      gnuplot_text(sheet.across.label),
      gnuplot_text(sheet.up.label),
      axis_of(sheet, "x"),
      axis_of(sheet, "y"));
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
