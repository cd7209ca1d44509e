// SPDX-License-Identifier: MIT
#include "frame/timeline.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"

namespace polhode {
namespace {

// the number with at most ten digits that is that near, else t
double shortened(double t, double rounding) {
  constexpr int kDigits = 10, kMostPower = 22;  // powers of ten that are doubles
  if (!(t > 0.0)) return t;
  const int power = kDigits - 1 - static_cast<int>(std::floor(std::log10(t)));
  if (power < 0 || power > kMostPower) return t;
  const double factor = std::pow(10.0, power);
  const double nearest = std::round(t * factor) / factor;
  return std::abs(nearest - t) <= rounding ? nearest : t;
}

bool names(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

double eased(double part) {
  const double s = std::clamp(part, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

Timeline::Timeline(const std::vector<StoryStep>& story, double duration, double time_scale)
    : story_(story), duration_(duration), time_scale_(time_scale) {
  for (std::size_t i = 0; i < story_.size(); ++i) {
    for (const std::string& element : story_[i].show) {
      if (!names(story_[i].hide, element)) continue;
      throw input_error("'{}' is shown and hidden at once", element)
          .at({{}, 0, fmt::format("story[{}].hide", i)});
    }
    story_[i].at = up_to(duration, story_[i].at);
    if (story_[i].at <= duration) continue;
    throw input_error("must be a time within the motion, 0 to {} s, got {}", duration, story_[i].at)
        .at({{}, 0, fmt::format("story[{}].at", i)});
  }
  std::stable_sort(story_.begin(), story_.end(), [](const StoryStep& a, const StoryStep& b) {
    return a.at < b.at;
  });
  double held = 0.0;
  for (const StoryStep& step : story_) {
    const double begins = step.at / time_scale_ + held;
    starts_.push_back(begins);
    if (step.hold <= 0.0) continue;
    held += step.hold;
    pauses_.push_back({begins, begins + step.hold, step.at, step.caption.value_or("")});
  }
}

template <class Counts>
double Timeline::held(const Counts& counts) const {
  double sum = 0.0;
  for (const Pause& pause : pauses_) {
    if (counts(pause)) sum += pause.ends - pause.begins;
  }
  return sum;
}

double Timeline::film_duration() const {
  return film_time(duration_);
}

double Timeline::motion_time(double film) const {
  for (const Pause& pause : pauses_) {
    if (reached(film, pause.begins) && !reached(film, pause.ends)) return pause.at;
  }
  constexpr double kRounding = 1e-13;
  const double before = held([&](const Pause& pause) { return reached(film, pause.ends); });
  const double t = shortened((film - before) * time_scale_, kRounding * (1.0 + film) * time_scale_);
  return std::min(t, duration_);
}

double Timeline::film_time(double motion) const {
  return motion / time_scale_ + held([&](const Pause& pause) { return pause.at <= motion; });
}

double Timeline::first_film_time(double motion) const {
  return motion / time_scale_ + held([&](const Pause& pause) { return pause.at < motion; });
}

double Timeline::presence(const std::string& element, double film) const {
  // what the story will show is not there before; the last word that was said holds
  double now = 1.0;
  for (const StoryStep& step : story_) {
    if (!names(step.show, element) && !names(step.hide, element)) continue;
    now = names(step.show, element) ? 0.0 : 1.0;
    break;
  }
  for (std::size_t i = 0; i < story_.size(); ++i) {
    const StoryStep& step = story_[i];
    const bool comes = names(step.show, element);
    if ((!comes && !names(step.hide, element)) || !reached(film, starts_[i])) continue;
    const double part = step.fade > 0.0 ? eased((film - starts_[i]) / step.fade) : 1.0;
    now += part * ((comes ? 1.0 : 0.0) - now);
  }
  return now;
}

std::optional<std::string> Timeline::caption(double film) const {
  std::optional<std::string> words;
  for (std::size_t i = 0; i < story_.size(); ++i) {
    if (reached(film, starts_[i]) && story_[i].caption) words = story_[i].caption;
  }
  return words;
}

}  // namespace polhode
