// SPDX-License-Identifier: MIT
// Which moments of the motion a film shows: its clock and the times of its frames.
#pragma once

#include <optional>

#include "film/solved_scene.h"
#include "frame/timeline.h"
#include "motion/loop.h"

namespace polhode {

// Which part of the motion a film shows, in seconds of the motion.
struct TimeRange {
  std::optional<double> from, to;  // absent: the start, the end
  std::optional<double> still;     // one picture
  bool one_picture = false;
};

// Which moments are drawn: frame i shows the film at first + i / fps.
struct FrameTimes {
  Timeline timeline;
  double first = 0.0;  // s of the film
  double rate = 60.0;  // frames per s of film
  int count = 1;
  double from = 0.0, to = 0.0;    // s of the motion
  std::optional<Loop> loop = {};  // where the film closes

  double film_time(int index) const { return first + index / rate; }
};

// Checks the range against the scene alone: what can be refused before any work is.
void check_time_range(const Scene& scene, const TimeRange& range);

// Throws Error (input) for times outside the motion (naming the option), too many frames.
FrameTimes plan_frame_times(const Solved& solved, const TimeRange& range);

}  // namespace polhode
