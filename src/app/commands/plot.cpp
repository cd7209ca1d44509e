// SPDX-License-Identifier: MIT
#include "app/commands/plot.h"

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "base/error.h"
#include "base/nearest.h"
#include "base/numbers.h"
#include "base/system/atomic_file.h"
#include "base/system/overwriting.h"
#include "chart/plot_sheet.h"
#include "film/solved_scene.h"
#include "motion/diagram.h"
#include "motion/recorded.h"

namespace polhode {
namespace {

constexpr int kLeastSteps = 2400;  // over the whole motion
constexpr int kMostDrawn = 6000;   // more than two for each column of a large picture

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{}, {}", name, unit);
}

PlotSheet sheet_of(const Recorded& quantity,
                   const Motion& motion,
                   const std::string& title,
                   bool as_table) {
  // Okabe and Ito
  constexpr std::array<const char*, 3> kColors = {"#D55E00", "#0072B2", "#009E73"};
  PlotSheet sheet;
  sheet.title = title.empty() ? quantity.title : fmt::format("{}: {}", title, quantity.title);
  sheet.across = {"time, s", 0.0, motion.duration()};
  sheet.up.label = with_unit(quantity.title, quantity.unit);
  for (std::size_t k = 0; k < quantity.curves.size(); ++k)
    sheet.curves.push_back({quantity.curves[k], kColors[k % kColors.size()], 2.0, {}});
  const int steps = steps_to_show(motion, motion.duration(), kLeastSteps);
  if (steps == kMostShown) {
    spdlog::warn(
        "the body or a load turns too often for a plot of all the motion; shorten motion.duration");
  }
  const double end = motion.duration();
  const std::vector<std::vector<double>> all =
      as_table ? values_over_time(quantity, motion, end, steps)
               : drawn_values(quantity, motion, end, steps, kMostDrawn);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::vector<double>& values = all[k];
    const double last = static_cast<double>(values.size()) - 1.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double t = end * static_cast<double>(i) / last;
      sheet.curves[k].points.emplace_back(t, values[i]);
    }
  }
  return sheet;
}

PlotSheet sheet_of(const Diagram& diagram, const std::string& title, std::optional<double> at) {
  using Kind = DiagramCurve::Kind;
  PlotSheet sheet;
  sheet.title = title.empty() ? diagram.title : fmt::format("{}: {}", title, diagram.title);
  sheet.across = {
      with_unit(diagram.across.name, diagram.across.unit), diagram.across.low, diagram.across.high};
  sheet.up = {with_unit(diagram.up.name.empty() ? diagram.title : diagram.up.name, diagram.up.unit),
              diagram.up.low,
              diagram.up.high};
  struct Look {
    Kind kind;
    const char* name;
    const char* color;
    double width;
  };
  // those of other motions under all others
  constexpr std::array<Look, 6> kLooks = {{{Kind::other, "", "#A0A0A0", 1.0},
                                           {Kind::separatrix, "separatrix", "#8C2D04", 2.0},
                                           {Kind::boundary, "stable within", "#0072B2", 2.0},
                                           {Kind::potential, "U", "#0072B2", 2.5},
                                           {Kind::energy, "E", "#D55E00", 1.5},
                                           {Kind::motion, "the motion", "#D55E00", 2.5}}};
  for (const Look& look : kLooks) {
    for (const DiagramCurve& curve : diagram.curves) {
      if (curve.kind == look.kind)
        sheet.curves.push_back({look.name, look.color, look.width, curve.points});
    }
  }
  for (const DiagramMark& mark : diagram.marks)
    sheet.marks.push_back({mark.name, mark.at, mark.stable});
  if (at) sheet.marks.push_back({"", diagram.now(*at), true, "#D55E00"});
  return sheet;
}

// absent: a table
std::optional<PlotFormat> format_of(const std::string& output) {
  const std::string ending = std::filesystem::path(output).extension().string();
  if (ending == ".csv") return std::nullopt;
  if (ending == ".svg") return PlotFormat::svg;
  if (ending == ".png") return PlotFormat::png;
  if (ending == ".pdf") return PlotFormat::pdf;
  throw input_error("a plot is written as .svg, .png, .pdf or .csv, not as '{}'", ending)
      .at({output, 0, {}});
}

}  // namespace

void draw_plot(const PlotJob& job) {
  const DiagramKind* kind = find_diagram(job.name);
  const Recorded* quantity = find_recorded(job.name);
  if (kind == nullptr && quantity == nullptr) {
    throw input_error("no plot is called '{}'{}", job.name, suggestion(job.name, plot_names()))
        .at({{}, 0, "PLOT"});
  }
  const std::optional<PlotFormat> format = format_of(job.output);
  const Scene scene = load_single(job.scene, job.overrides);
  refuse_same_file(job.output, "the output", input_files(scene));
  if (job.at && kind == nullptr) {
    throw input_error("marks a point in a diagram; '{}' shows all times", job.name)
        .at({{}, 0, "--at"});
  }
  std::optional<double> at = job.at;
  if (at) at = up_to(scene.motion.duration, *at);
  if (at && !(*at >= 0.0 && *at <= scene.motion.duration)) {
    throw input_error(
        "must be a time within the motion, 0 to {} s, got {}", scene.motion.duration, *at)
        .at({{}, 0, "--at"});
  }
  if (format) require_gnuplot();
  const Solved solved = solve_alone(scene, ProgressKind::automatic);
  const Motion& motion = solved.simulation.motion;
  const std::string wrong = kind != nullptr ? kind->why_not(motion) : why_not(*quantity, motion);
  if (!wrong.empty()) throw input_error("'{}' {}", job.name, wrong).at({{}, 0, "PLOT"});
  const PlotSheet sheet = kind != nullptr ? sheet_of(kind->make(motion), scene.title, at)
                                          : sheet_of(*quantity, motion, scene.title, !format);
  write_file(job.output, format ? draw_sheet(sheet, *format) : sheet_csv(sheet));
}

}  // namespace polhode
