// SPDX-License-Identifier: MIT
// Converts between film time and motion time, and says what the story shows at a film time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/view_spec.h"

namespace polhode {

// A step of the story at which the motion stands still.
struct Pause {
  double begins = 0.0;  // s of film
  double ends = 0.0;    // s of film
  double at = 0.0;      // s of motion
  std::string caption;
};

// Immutable. Without a story, film time is motion time divided by the time scale.
class Timeline {
 public:
  Timeline() = default;
  // The motion from 0 to `duration` (s) at `time_scale` seconds of motion per second of film.
  // Throws Error (input), naming story[i].at, for a step after the end.
  Timeline(const std::vector<StoryStep>& story, double duration, double time_scale);

  // The timeline of the same motion with another story.
  Timeline retold(const std::vector<StoryStep>& story) const {
    return Timeline(story, duration_, time_scale_);
  }

  // The length of the film, s. Film time begins at 0.
  double film_duration() const;
  // The motion time that is shown at a film time.
  double motion_time(double film) const;
  // The last and the first film time that show this motion time; they differ at a pause.
  double film_time(double motion) const;
  double first_film_time(double motion) const;
  // How far the story lets the element of that name be visible: 1 fully, 0 not at all, in between
  // while it fades.
  double presence(const std::string& element, double film) const;
  // The story's caption at this film time; empty before the first.
  std::optional<std::string> caption(double film) const;
  // All pauses, by time.
  const std::vector<Pause>& pauses() const { return pauses_; }
  // The steps sorted by time, and when each begins (s of film).
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

// Smoothstep: rises from 0 at 0 to 1 at 1 with zero slope at both ends.
double eased(double part);

}  // namespace polhode
