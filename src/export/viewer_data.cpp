// SPDX-License-Identifier: MIT
#include "export/viewer_data.h"

#include <algorithm>

#include "base/error.h"
#include "base/json.h"
#include "frame/elements.h"
#include "frame/timeline.h"
#include "motion/recorded.h"

namespace polhode {
namespace {

constexpr int kFewestReadings = 240, kMostReadings = 2000;  // of the numbers that are read out
constexpr int kPlotSteps = 600;

Json plots_of(const Solved& solved, double to) {
  Json plots = Json::array();
  const Motion& motion = solved.simulation.motion;
  for (const std::string& name : solved.scene.show.plots) {
    const Recorded* quantity = find_recorded(name);
    if (quantity == nullptr) continue;  // a diagram
    if (const std::string wrong = why_not(*quantity, motion); !wrong.empty())
      throw input_error("'{}' {}", name, wrong).at({{}, 0, "show.plots"});
    const int steps = steps_to_show(motion, to, kPlotSteps);
    Json curves = Json::array();
    const auto all = values_over_time(*quantity, motion, to, steps);
    for (std::size_t k = 0; k < all.size(); ++k) {
      curves.push_back(
          {{"name", quantity->curves[k]}, {"values", extremes_of(all[k], kPlotSteps)}});
    }
    plots.push_back({{"title", quantity->title}, {"unit", quantity->unit}, {"curves", curves}});
  }
  return plots;
}

}  // namespace

Json viewer_data(const Solved& solved, double from, double to) {
  const Motion& motion = solved.simulation.motion;
  const Scene& scene = solved.scene;
  Json data = {{"from", from},
               {"to", to},
               {"scale", scene.video.time_scale},
               {"fps", scene.video.fps.value()},
               {"title", scene.title},
               {"pauses", Json::array()},
               {"captions", Json::array()},
               {"story", Json::array()},
               {"plots", plots_of(solved, to)}};
  const Timeline timeline(scene.story, motion.duration(), scene.video.time_scale);
  for (const Pause& pause : timeline.pauses()) {
    if (pause.at >= from && pause.at <= to)
      data["pauses"].push_back({{"at", pause.at}, {"caption", pause.caption}});
  }
  for (const StoryStep& step : timeline.steps()) {
    if (!step.show.empty() || !step.hide.empty())
      data["story"].push_back({{"at", step.at}, {"show", step.show}, {"hide", step.hide}});
    if (step.caption) data["captions"].push_back({{"at", step.at}, {"caption", *step.caption}});
  }
  const int steps =
      std::clamp(steps_to_show(motion, to, kFewestReadings), kFewestReadings, kMostReadings);
  Json omega = Json::array(), momentum = Json::array(), energy = Json::array();
  for (int i = 0; i <= steps; ++i) {
    const Sample now = motion.at(std::min(from + (to - from) * i / steps, motion.duration()));
    omega.push_back(now.w_S.norm());
    momentum.push_back(now.L_S.norm());
    energy.push_back(now.energy);
  }
  data["series"] = {{"omega", omega}, {"momentum", momentum}, {"energy", energy}};
  for (const ShowName& element : show_names())
    data["elements"][element.name] = element.doc;
  return data;
}

}  // namespace polhode
