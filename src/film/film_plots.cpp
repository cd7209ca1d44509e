// SPDX-License-Identifier: MIT
#include "film/film_plots.h"

#include <algorithm>
#include <cmath>
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
constexpr int kLeastSteps = 400;  // of one of several motions that follow one another

// what one of `count` curves is called beside those of other panels
std::string beside_others(const std::string& name, std::size_t count, const std::string& caption) {
  if (caption.empty()) return name;
  if (count == 1) return caption;
  return fmt::format("{}, {}", name, caption);
}

// the colours and dashes that can be told apart
constexpr std::size_t kMostCurves = 6;

// the values of a motion over `end` s, as few as show them
std::vector<std::vector<double>> shown_values(const Recorded& quantity,
                                              const Motion& motion,
                                              double end,
                                              int most) {
  const int steps = steps_to_show(motion, end, most);
  if (steps == kMostShown) {
    spdlog::warn(
        "show.plots: the body or a load turns too often for a plot '{}' of all the motion; shorten "
        "motion.duration",
        quantity.name);
  }
  return drawn_values(quantity, motion, end, steps, most);
}

// one motion after the other, with a gap between
FilmPlot plot_in_turn(const Recorded& quantity, const std::vector<Solved>& solved) {
  FilmPlot plot;
  plot.title = quantity.title;
  plot.unit = quantity.unit;
  for (const std::string& name : curve_names(quantity, solved.front().simulation.motion))
    plot.curves.push_back({name, {}});
  const double each = solved.front().scene.motion.duration;
  const auto count = static_cast<int>(solved.size());
  plot.ends = count * each;
  const int steps = std::max(kSteps / count, kLeastSteps);
  std::vector<Motion> motions;
  for (const Solved& one : solved) {
    motions.push_back(one.simulation.motion);
    const auto values = shown_values(quantity, motions.back(), each, steps);
    for (std::size_t k = 0; k < values.size(); ++k) {
      // values stand at equal steps: the first of a motion takes the place of the last before it
      std::vector<double>& all = plot.curves[k].values;
      std::vector<double> own = values[k];
      own.resize(static_cast<std::size_t>(steps) + 1, own.back());
      if (!all.empty()) all.back() = NAN;
      all.insert(all.end(), own.begin() + (all.empty() ? 0 : 1), own.end());
    }
  }
  plot.now = [motions, each, values = quantity.values](double t) {
    const double turn = std::min(std::floor(t / each), static_cast<double>(motions.size() - 1));
    const Motion& motion = motions[static_cast<std::size_t>(turn)];
    return values(motion, motion.at(std::min(t - turn * each, motion.duration())));
  };
  return plot;
}

// panels without the quantity have no curve, but one panel must have it
void require_any(const Recorded& quantity, const std::vector<Solved>& solved) {
  std::string wrong;
  for (const Solved& one : solved) {
    wrong = why_not(quantity, one.simulation.motion);
    if (wrong.empty()) return;
  }
  throw input_error("'{}' {}", quantity.name, wrong).at({{}, 0, "show.plots"});
}

FilmPlot plot_of(const Recorded& quantity, const std::vector<Solved>& solved) {
  if (solved.front().scene.in_turn) return plot_in_turn(quantity, solved);
  FilmPlot plot;
  plot.title = quantity.title;
  plot.unit = quantity.unit;
  const std::vector<ScenePanel>& panels = solved.front().scene.panels;
  std::vector<Motion> motions;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    if (!why_not(quantity, solved[i].simulation.motion).empty()) continue;
    motions.push_back(solved[i].simulation.motion);
    const std::string caption = panels.empty() ? "" : panels[i].caption;
    const std::vector<std::string> names = curve_names(quantity, motions.back());
    for (const std::string& name : names)
      plot.curves.push_back({beside_others(name, names.size(), caption), {}});
  }
  if (plot.curves.size() > kMostCurves) {
    throw input_error(
        "a plot holds {} curves, and '{}' of {} panels has {}; choose another quantity",
        kMostCurves,
        quantity.name,
        motions.size(),
        plot.curves.size())
        .at({{}, 0, "show.plots"});
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
    for (std::vector<double>& values : shown_values(quantity, motion, plot.ends, kSteps))
      plot.curves[curve++].values = std::move(values);
  }
  return plot;
}

// A diagram of each motion, on the same axes.
std::vector<Diagram> diagrams_of(const DiagramKind& kind, const std::vector<Solved>& solved) {
  std::vector<Diagram> found;
  for (const Solved& one : solved) {
    const Motion& motion = one.simulation.motion;
    const std::string wrong = kind.why_not(motion);
    if (!wrong.empty()) throw input_error("'{}' {}", kind.name, wrong).at({{}, 0, "show.plots"});
    found.push_back(kind.make(motion));
  }
  const auto widen = [&](DiagramAxis Diagram::*axis) {
    double low = (found.front().*axis).low, high = (found.front().*axis).high;
    for (const Diagram& one : found) {
      low = std::min(low, (one.*axis).low);
      high = std::max(high, (one.*axis).high);
    }
    for (Diagram& one : found) {
      (one.*axis).low = low;
      (one.*axis).high = high;
    }
  };
  widen(&Diagram::across);
  widen(&Diagram::up);
  // the level of the energy reaches from edge to edge
  for (Diagram& one : found) {
    for (DiagramCurve& curve : one.curves) {
      if (curve.kind != DiagramCurve::Kind::energy || curve.points.empty()) continue;
      curve.points.front().x() = one.across.low;
      curve.points.back().x() = one.across.high;
    }
  }
  return found;
}

// In the place of one diagram stands that of the motion or of the panel whose turn it is; those of
// panels side by side stand one below the other, under their captions.
void add_diagrams(const DiagramKind& kind, const std::vector<Solved>& solved, FilmCharts& charts) {
  constexpr std::size_t kMost = 2;  // which are large enough to be read
  const Scene& scene = solved.front().scene;
  std::vector<Diagram> found = diagrams_of(kind, solved);
  if (found.size() == 1 || scene.in_turn) {
    charts.diagrams.push_back(std::move(found));
    return;
  }
  if (charts.diagrams.size() + found.size() > kMost) {
    throw input_error(
        "'{}' of {} panels side by side needs too much room: there is enough for {} diagrams; give "
        "them arrange = \"in_turn\", one after the other",
        kind.name,
        found.size(),
        kMost)
        .at({{}, 0, "show.plots"});
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i < scene.panels.size() && !scene.panels[i].caption.empty())
      found[i].title = scene.panels[i].caption + ": " + found[i].title;
    charts.diagrams.push_back({std::move(found[i])});
  }
}

}  // namespace

FilmCharts make_charts(const std::vector<Solved>& solved) {
  FilmCharts charts;
  for (const std::string& name : solved.front().scene.show.plots) {
    if (const DiagramKind* kind = find_diagram(name)) {
      add_diagrams(*kind, solved, charts);
      continue;
    }
    if (const Recorded* quantity = find_recorded(name)) {
      require_any(*quantity, solved);
      charts.plots.push_back(plot_of(*quantity, solved));
    }
  }
  return charts;
}

}  // namespace polhode
