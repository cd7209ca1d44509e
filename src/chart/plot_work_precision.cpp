// SPDX-License-Identifier: MIT
#include "chart/plot_work_precision.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/csv.h"
#include "motion/stepper_table.h"

namespace polhode {
namespace {

constexpr int kWidth = 1500;
constexpr int kPanelHeight = 700;

// of families, in the order of MethodFamily: Okabe and Ito's without black and yellow, then darker
// ones, told apart by the colour-blind
constexpr std::array<const char*, 9> kColors = {"#7F7F7F",
                                                "#0072B2",
                                                "#56B4E9",
                                                "#D55E00",
                                                "#5D3A9B",
                                                "#009E73",
                                                "#E69F00",
                                                "#CC79A7",
                                                "#8C4A2F"};
// of the methods of a family, marks of gnuplot: disc, square, triangles, diamond, open circle and
// square
constexpr std::array<int, 7> kMarks = {7, 5, 9, 11, 13, 6, 4};

// the methods of the points, in their order
std::vector<std::string> methods_of(const std::vector<WorkPoint>& points) {
  std::vector<std::string> names;
  for (const WorkPoint& p : points) {
    if (names.empty() || names.back() != p.method) names.push_back(p.method);
  }
  return names;
}

// A method looks the same in every chart: the colour of its family, and a mark by its place there.
std::string look_of(const std::string& method) {
  const MethodFamily family = find_stepper(method).family;
  std::size_t before = 0;  // methods of the family
  for (const StepperInfo& row : stepper_table()) {
    if (row.name == method) break;
    before += row.family == family ? 1 : 0;
  }
  return fmt::format("linecolor rgb '{}' pointtype {} pointsize 0.8 linewidth 1.3",
                     kColors.at(static_cast<std::size_t>(family)),
                     kMarks[before % kMarks.size()]);
}

// a named block of numbers, time_us evaluations error_rad, with what is drawn of the method
std::string data_block(const std::string& name,
                       const std::vector<WorkPoint>& points,
                       const std::string& method) {
  std::string text = "$" + name + " << EOD\n";
  for (const WorkPoint& p : points) {
    if (p.method != method || p.status != kPointOk || p.error_rad > 10.0) continue;
    text += fmt::format(
        "{} {} {}\n", gnuplot_number(p.time_us), p.evaluations, gnuplot_number(p.error_rad));
  }
  return text + "EOD\n";
}

// the number that a method is cheapest by
using Cost = double (*)(const WorkPoint& p);
double time_of(const WorkPoint& p) {
  return p.time_us;
}
double evaluations_of(const WorkPoint& p) {
  return static_cast<double>(p.evaluations);
}

// the cheapest drawn point with an error of at most this
const WorkPoint* best_drawn(const std::vector<WorkPoint>& points, double error, Cost cost) {
  const WorkPoint* best = nullptr;
  for (const WorkPoint& p : points) {
    if (p.status != kPointOk || p.error_rad > error) continue;
    if (best == nullptr || cost(p) < cost(*best)) best = &p;
  }
  return best;
}

// names at the points that are cheapest at an accuracy, one wherever the name changes
std::string frontier_labels(const std::vector<WorkPoint>& points, Cost cost) {
  std::string text;
  const WorkPoint* last = nullptr;
  int tag = 1;
  for (double error = 1.0; error > 1e-15; error *= 0.1) {
    const WorkPoint* best = best_drawn(points, error, cost);
    if (best == nullptr) break;
    if (last != nullptr && best->method == last->method) continue;
    last = best;
    text += fmt::format("set label {} {} at {},{} right offset -0.8,-0.3 front\n",
                        tag++,
                        gnuplot_text(best->method),
                        gnuplot_number(cost(*best)),
                        gnuplot_number(best->error_rad));
  }
  return text;
}

std::string cheapest_words(const WorkPanel& panel) {
  const WorkPoint* best = cheapest(panel.points, panel.accuracy_rad);
  const std::string line =
      fmt::format("line: {} = {:.2g} rad", panel.accuracy_why, panel.accuracy_rad);
  if (best == nullptr) return line + "; nothing here is known to be below it";
  return fmt::format("{}; cheapest below it: {} with {} {:.3g}, {:.3g} µs",
                     line,
                     best->method,
                     find_stepper(best->method).adaptive ? "tolerance" : "step",
                     best->step,
                     best->time_us);
}

// why some methods need one step only
std::string exact_label(const WorkPanel& panel) {
  if (!panel.free_body) return {};
  for (const std::string& name : methods_of(panel.points)) {
    const StepperInfo& method = find_stepper(name);
    if (!method.exact_when_free) continue;
    return fmt::format(
        "set label 101 {} at graph 0.02, graph 0.03 left front font ',9'\n",
        gnuplot_text(family_title(method.family) + ": exact on a free body, but for round-off"));
  }
  return {};
}

// from the decade below the cheapest point, so that its name has room
std::string range_of(const std::vector<WorkPoint>& points, Cost cost) {
  const WorkPoint* least = best_drawn(points, 10.0, cost);
  const double low = std::pow(10.0, std::floor(std::log10(std::max(cost(*least), 1e-3))) - 1.0);
  return fmt::format("set xrange [{}:*]\n", gnuplot_number(low));
}

// one panel of a row: error over `column` of the data
std::string panel_script(const WorkPanel& panel,
                         std::size_t row,
                         int column,
                         const std::string& axis,
                         Cost cost,
                         bool with_key) {
  const std::vector<std::string> names = methods_of(panel.points);
  std::string text = "unset arrow\n";
  text += frontier_labels(panel.points, cost);
  text += exact_label(panel);
  text += range_of(panel.points, cost);
  // what the scene needs, as a line over the whole width
  text += fmt::format(
      "set arrow 1 from graph 0, first {0} to graph 1, first {0} nohead linewidth 1.5 dashtype 2 "
      "linecolor rgb '#444444' front\n",
      gnuplot_number(panel.accuracy_rad));
  text += with_key ? "set key outside right top vertical Left reverse samplen 2 font ',9'\n"
                   : "unset key\n";
  text += "set xlabel " + gnuplot_text(axis) + "\n";
  std::string curves;
  for (std::size_t i = 0; i < names.size(); ++i) {
    curves += fmt::format("{}$scene{}_{} using {}:3 with linespoints {} title {}",
                          curves.empty() ? "plot " : ", ",
                          row,
                          i,
                          column,
                          look_of(names[i]),
                          gnuplot_text(names[i]));
  }
  return text + curves + "\n";
}

bool anything_drawn(const WorkPanel& panel) {
  return best_drawn(panel.points, 10.0, time_of) != nullptr;
}

// a row: two panels, a title over each
std::string row_script(const WorkPanel& panel, std::size_t row, std::size_t rows) {
  const double height = 1.0 / static_cast<double>(rows);
  const double bottom = 1.0 - height * static_cast<double>(row + 1);
  std::string text;
  const std::vector<std::string> names = methods_of(panel.points);
  for (std::size_t i = 0; i < names.size(); ++i)
    text += data_block(fmt::format("scene{}_{}", row, i), panel.points, names[i]);
  const auto place = [&](double left, double width, const std::string& title) {
    text += "unset label\n";
    text += fmt::format(
        "set origin {:.4f},{:.6f}\nset size {:.4f},{:.6f}\n"
        "set title ' '\nset label 100 {} at graph 0, graph 1 left offset 0,0.9\n",
        left,
        bottom,
        width,
        height,
        gnuplot_text(title));
  };
  if (!anything_drawn(panel)) {
    place(0.0, 1.0, panel.title + ": nothing to draw; reference: " + panel.reference);
    return text + "unset arrow\nunset key\nset xlabel ''\nplot [1:10][1e-14:1] NaN notitle\n";
  }
  place(0.0, 0.42, panel.title + "; reference: " + panel.reference);
  text += panel_script(panel, row, 1, "time of the whole motion, µs", time_of, false);
  place(0.42, 0.58, cheapest_words(panel));
  text += panel_script(panel,
                       row,
                       2,
                       "evaluations (right-hand sides, Newton steps, partial flows)",
                       evaluations_of,
                       true);
  return text;
}

}  // namespace

std::string work_precision_script(const std::vector<WorkPanel>& panels) {
  std::string script =
      "set multiplot\n"
      "set logscale xy\n"
      "set format x '10^{%L}'\nset format y '10^{%L}'\n"
      "set key noenhanced\n"
      "set grid linecolor rgb '#dddddd' linewidth 0.5\n"
      "set yrange [*:10]\n"
      "set ylabel 'largest attitude error, rad'\n";
  for (std::size_t row = 0; row < panels.size(); ++row)
    script += row_script(panels[row], row, panels.size());
  return script + "unset multiplot\n";
}

std::string plot_work_precision(const std::vector<WorkPanel>& panels, PlotFormat format) {
  return draw_with_gnuplot(work_precision_script(panels),
                           format,
                           kWidth,
                           kPanelHeight * static_cast<int>(panels.size()));
}

std::string work_precision_csv(const std::vector<WorkPanel>& panels) {
  std::string text =
      "scene,method,order,step,evaluations,time_us,error_rad,energy_drift,momentum_drift,status\n";
  for (const WorkPanel& panel : panels) {
    for (const WorkPoint& p : panel.points) {
      text += fmt::format("{},{},{},{:.17g},{},{:.6g},{:.6g},{:.6g},{:.6g},{}\n",
                          csv_field(panel.scene),
                          p.method,
                          p.order,
                          p.step,
                          p.evaluations,
                          p.time_us,
                          p.error_rad,
                          p.energy_drift,
                          p.momentum_drift,
                          p.status);
    }
  }
  return text;
}

}  // namespace polhode
