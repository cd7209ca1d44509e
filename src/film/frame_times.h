// SPDX-License-Identifier: MIT
// Which times of the motion a film shows: its timeline and the times of its frames.
#pragma once

#include <optional>

#include "film/solved_scene.h"
#include "frame/timeline.h"
#include "motion/closed_loop.h"

namespace polhode {

// The part of the motion that a film shows, in seconds of motion.
struct TimeRange {
  std::optional<double> from, to;  // absent: start, end of the motion
  std::optional<double> still;     // time of a single picture; absent: `from`
  bool one_picture = false;
};

// The times of the frames: frame i shows the film at the time first + i / rate.
struct FrameTimes {
  Timeline timeline;
  double first = 0.0;  // s of film
  double rate = 60.0;  // frames per s of film
  int count = 1;
  double from = 0.0, to = 0.0;    // s of motion
  std::optional<Loop> loop = {};  // of a looping film

  // The time of a frame, s of film.
  double film_time(int index) const { return first + index / rate; }
};

// Checks what can be checked before the motion is computed. Throws Error (input) naming --from,
// --to or --still for a time outside the motion or in the wrong order, and without a key for too
// many frames.
void check_time_range(const Scene& scene, const TimeRange& range);

// The frame times of a range that check_time_range accepts. Throws Error (input) naming story[i].at
// for a step after the end, and without a key for too many frames.
FrameTimes plan_frame_times(const Solved& solved, const TimeRange& range);

}  // namespace polhode
