// SPDX-License-Identifier: MIT
#include "export/viewer_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "base/numbers.h"
#include "base/system/interrupt.h"
#include "export/key_times.h"
#include "frame/elements.h"
#include "frame/timeline.h"
#include "motion/recorded.h"

namespace polhode {
namespace {

constexpr int kPlotSteps = 600;

// The numbers that are read out, at times between which a page goes in straight lines.
constexpr std::size_t kMostReadings = 20'000;
constexpr double kInFourDigits = 5e-5;  // of the largest
constexpr double kJump = 1e-5;          // of the time shown: what is longer is no jump

struct Reading {
  double t = 0.0;               // s of motion
  std::array<double, 3> value;  // |Omega|, |L|, energy
};

class Readings {
 public:
  Readings(const Motion& motion, double from, double to) : motion_(motion), span_(to - from) {
    const std::vector<double> first = first_times(motion, {from, to, 1.0});
    all_.reserve(2 * first.size());
    std::vector<Reading> looks;
    looks.reserve(first.size());
    for (const double played : first)
      looks.push_back(at(std::min(from + played, to)));
    looks.back() = at(to);
    for (const Reading& look : looks)
      note_size(look);
    all_ = {looks.front()};
    for (std::size_t i = 0; i + 1 < looks.size(); ++i)
      add(looks[i], looks[i + 1]);
  }

  // as few of them as are off by no more than `part` of the largest
  std::vector<Reading> thinned(double part) const {
    std::vector<Reading> kept = {all_.front()};
    for (std::size_t from = 0; from + 1 < all_.size();) {
      std::size_t to = from + 1, step = 1;
      // farther and farther, and then back
      while (to + step < all_.size() && spans(from, to + step, part)) {
        to += step;
        step *= 2;
      }
      for (; step > 0; step /= 2)
        if (to + step < all_.size() && spans(from, to + step, part)) to += step;
      kept.push_back(all_[to]);
      from = to;
    }
    return kept;
  }

 private:
  Reading at(double t) const {
    stop_if_interrupted();
    const Sample now = motion_.at(std::min(t, motion_.duration()));
    return {t, {now.w_S.norm(), now.L_S.norm(), now.energy}};
  }
  void note_size(const Reading& one) {
    for (std::size_t i = 0; i < largest_.size(); ++i)
      largest_[i] = std::max(largest_[i], std::abs(one.value[i]));
  }
  // how far `now` is from the line between two, as a part of the largest
  double error(const Reading& a, const Reading& now, const Reading& b) const {
    const double part = (now.t - a.t) / (b.t - a.t);
    double worst = 0.0;
    for (std::size_t i = 0; i < largest_.size(); ++i) {
      const double line = a.value[i] + part * (b.value[i] - a.value[i]);
      if (largest_[i] > 0.0) worst = std::max(worst, std::abs(now.value[i] - line) / largest_[i]);
    }
    return worst;
  }
  // what comes after a up to b
  void add(const Reading& a, const Reading& b) {
    const double length = b.t - a.t;
    if (length > kJump * span_ && all_.size() < kMostLooks) {
      const Reading middle = at(a.t + 0.5 * length);
      double worst = error(a, middle, b);
      for (const double part : {0.25, 0.75}) {
        if (worst <= kInFourDigits) worst = std::max(worst, error(a, at(a.t + part * length), b));
      }
      if (worst > kInFourDigits) {
        note_size(middle);
        add(a, middle);
        add(middle, b);
        return;
      }
    }
    all_.push_back(b);
  }
  bool spans(std::size_t from, std::size_t to, double part) const {
    for (std::size_t i = from + 1; i < to; ++i)
      if (error(all_[from], all_[i], all_[to]) > part) return false;
    return true;
  }

  static constexpr std::size_t kMostLooks = 2'000'000;
  const Motion& motion_;
  double span_;
  std::array<double, 3> largest_ = {};
  std::vector<Reading> all_;
};

double in_digits(double value, int digits) {
  return parse_number(fmt::format("{:.{}g}", value, digits)).value_or(value);
}

// "times" (s of motion), what is read then, and "digits" that are right in between
Json series_of(const Motion& motion, double from, double to) {
  const Readings readings(motion, from, to);
  int digits = 4;
  double part = kInFourDigits;
  std::vector<Reading> kept = readings.thinned(part);
  for (; kept.size() > kMostReadings && digits > 1; --digits) {
    part *= 10.0;
    kept = readings.thinned(part);
  }
  Json times = Json::array(), omega = times, momentum = times, energy = times;
  for (const Reading& one : kept) {
    times.push_back(in_digits(one.t, 9));
    omega.push_back(in_digits(one.value[0], 7));
    momentum.push_back(in_digits(one.value[1], 7));
    energy.push_back(in_digits(one.value[2], 7));
  }
  return {{"times", times},
          {"omega", omega},
          {"momentum", momentum},
          {"energy", energy},
          {"digits", digits}};
}

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
  data["series"] = series_of(motion, from, to);
  const Vec3& up = motion.model().up_S;
  data["up"] = {up.x(), up.z(), -up.y()};
  for (const ShowName& element : show_names())
    data["elements"][element.name] = element.doc;
  return data;
}

}  // namespace polhode
