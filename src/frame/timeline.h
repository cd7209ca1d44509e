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
  std::string caption;  // of the step; empty: none
};

// The map between film time and motion time. Immutable, so any thread may use it. Without a story,
// film time is motion time divided by the time scale.
class Timeline {
 public:
  Timeline() = default;  // of a motion without duration
  // The motion from 0 to `duration` (s) at `time_scale` (positive) seconds of motion per second of
  // film. Steps may be in any order. Throws Error (input), naming story[i].hide, for a step that
  // shows and hides one element, and story[i].at, for a step after the end.
  Timeline(const std::vector<StoryStep>& story, double duration, double time_scale);

  // The timeline of the same motion with another story. Throws Error as the constructor does.
  Timeline retold(const std::vector<StoryStep>& story) const {
    return Timeline(story, duration_, time_scale_);
  }

  // Seconds of motion per second of film, where nothing holds it.
  double time_scale() const { return time_scale_; }
  // The length of the film, s. Film time begins at 0.
  double film_duration() const;
  // The motion time (s) that is shown at a film time (s); after the end of the film, the duration
  // of the motion. A time that is a rounding off one of at most ten digits is that one: loads,
  // which begin at such times, then act from the same frame on, wherever a film begins.
  double motion_time(double film) const;
  // The last and the first film time (s) that show this motion time (s); they differ at a pause.
  double film_time(double motion) const;
  double first_film_time(double motion) const;
  // How visible the story makes an element (a name from element_names()): 1 fully, 0 not at all, in
  // between while it fades. 1 if the story does not mention it.
  double presence(const std::string& element, double film) const;
  // The story's caption at this film time; absent before the first one. An empty one means none.
  std::optional<std::string> caption(double film) const;
  // All pauses, by time.
  const std::vector<Pause>& pauses() const { return pauses_; }
  // The steps sorted by time, and when each begins (s of film).
  const std::vector<StoryStep>& steps() const { return story_; }
  const std::vector<double>& starts() const { return starts_; }

 private:
  // The total length of the pauses for which `counts` returns true, s of film.
  template <class Counts>
  double held(const Counts& counts) const;

  std::vector<StoryStep> story_;  // by time
  std::vector<double> starts_;    // of each step, s of the film
  std::vector<Pause> pauses_;
  double duration_ = 0.0;
  double time_scale_ = 1.0;
};

// Whether a film time (s) is at a moment of the film (s) or behind it. Times of frames are sums and
// quotients, which may be a rounding before the moment that is meant.
inline constexpr double kFilmRounding = 1e-9;  // s
inline bool reached(double film, double moment) {
  return film >= moment - kFilmRounding;
}

// Smoothstep: rises from 0 at 0 to 1 at 1 with zero slope at both ends.
double eased(double part);

}  // namespace polhode
