// SPDX-License-Identifier: MIT
// From the time of a film to the time of the motion, and what has come and gone by then.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/view_spec.h"

namespace polhode {

// A moment of the story on the film's own clock.
struct Pause {
  double begins = 0.0;  // s of the film
  double ends = 0.0;
  double at = 0.0;  // s of the motion
  std::string caption;
};

// Immutable. Without a story, film time is motion time divided by the time scale.
class Timeline {
 public:
  Timeline() = default;
  // The motion from 0 to `duration` (s) at `time_scale` seconds of motion per second of film.
  // Throws Error (input) for a step of the story at a later time.
  Timeline(const std::vector<StoryStep>& story, double duration, double time_scale);

  // The same clock for another telling of the story.
  Timeline retold(const std::vector<StoryStep>& story) const {
    return Timeline(story, duration_, time_scale_);
  }

  // All in seconds. The film begins at 0.
  double film_duration() const;
  double motion_time(double film) const;
  // The last moment of the film that shows this moment of the motion, and the first.
  double film_time(double motion) const;
  double first_film_time(double motion) const;
  // 1: the element of that name is there as far as the story goes, 0: it is not, between: it comes
  // or goes.
  double presence(const std::string& element, double film) const;
  // The story's words at this moment; none before its first.
  std::optional<std::string> caption(double film) const;
  const std::vector<Pause>& pauses() const { return pauses_; }
  // The steps by time, and when each begins, s of the film.
  const std::vector<StoryStep>& steps() const { return story_; }
  const std::vector<double>& starts() const { return starts_; }

 private:
  // How long the pauses that `counts` is true of have held the film, s.
  template <class Counts>
  double held(const Counts& counts) const;

  std::vector<StoryStep> story_;  // by time
  std::vector<double> starts_;    // of each step, s of the film
  std::vector<Pause> pauses_;
  double duration_ = 0.0;
  double time_scale_ = 1.0;
};

// 0 at 0, 1 at 1, without a jerk at the ends.
double eased(double part);

}  // namespace polhode
