// SPDX-License-Identifier: MIT
#include "film/film_plots.h"

#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "base/error.h"
#include "motion/diagram.h"
#include "motion/recorded.h"

namespace polhode {
namespace {

// more than two for each column of pixels that axes have in a large picture
constexpr int kSteps = 2400;

// what a curve is called beside those of other panels
std::string curve_name(const Recorded& quantity, std::size_t curve, const std::string& caption) {
  if (caption.empty()) return quantity.curves[curve];
  if (quantity.curves.size() == 1) return caption;
  return fmt::format("{}, {}", quantity.curves[curve], caption);
}

// the colours and dashes that can be told apart
constexpr std::size_t kMostCurves = 6;

FilmPlot plot_of(const Recorded& quantity, const std::vector<Solved>& solved) {
  if (quantity.curves.size() * solved.size() > kMostCurves) {
    throw input_error(
        "a plot holds {} curves, and '{}' of {} panels has {}; choose another quantity",
        kMostCurves,
        quantity.name,
        solved.size(),
        quantity.curves.size() * solved.size())
        .at({{}, 0, "show.plots"});
  }
  FilmPlot plot;
  plot.title = quantity.title;
  plot.unit = quantity.unit;
  const std::vector<ScenePanel>& panels = solved.front().scene.panels;
  std::vector<Motion> motions;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    motions.push_back(solved[i].simulation.motion);
    for (std::size_t k = 0; k < quantity.curves.size(); ++k)
      plot.curves.push_back({curve_name(quantity, k, panels.empty() ? "" : panels[i].caption), {}});
  }
  plot.begins = 0.0;
  plot.ends = motions.front().duration();
  plot.now = [motions, values = quantity.values](double t) {
    std::vector<double> all;
    for (const Motion& motion : motions) {
      const std::vector<double> here = values(motion, motion.at(t));
      all.insert(all.end(), here.begin(), here.end());
    }
    return all;
  };
  std::size_t curve = 0;
  for (const Motion& motion : motions) {
    const int steps = steps_to_show(motion, plot.ends, kSteps);
    if (steps == kMostShown) {
      spdlog::warn(
          "show.plots: the body turns too often for a plot of all its motion; shorten "
          "motion.duration");
    }
    for (const std::vector<double>& values : values_over_time(quantity, motion, plot.ends, steps))
      plot.curves[curve++].values = extremes_of(values, kSteps);
  }
  return plot;
}

Diagram diagram_of(const DiagramKind& kind, const std::vector<Solved>& solved) {
  const Motion& motion = solved.front().simulation.motion;
  if (solved.size() > 1) {
    throw input_error("'{}' shows one motion, not those of {} panels", kind.name, solved.size())
        .at({{}, 0, "show.plots"});
  }
  const std::string wrong = kind.why_not(motion);
  if (!wrong.empty()) throw input_error("'{}' {}", kind.name, wrong).at({{}, 0, "show.plots"});
  return kind.make(motion);
}

}  // namespace

FilmCharts make_charts(const std::vector<Solved>& solved) {
  FilmCharts charts;
  for (const std::string& name : solved.front().scene.show.plots) {
    if (const DiagramKind* kind = find_diagram(name)) {
      charts.diagrams.push_back(diagram_of(*kind, solved));
      continue;
    }
    for (const Recorded& quantity : recorded_quantities()) {
      if (quantity.name == name) charts.plots.push_back(plot_of(quantity, solved));
    }
  }
  return charts;
}

}  // namespace polhode
