// SPDX-License-Identifier: MIT
// Which times of the motion a film shows: its timeline and the times of its frames.
#pragma once

#include <optional>
#include <vector>

#include "film/solving.h"
#include "frame/timeline.h"
#include "motion/closed_loop.h"

namespace polhode {

// The part of the motion that a film shows, in seconds of motion; of panels in turn, of all their
// motions.
struct TimeRange {
  std::optional<double> from, to;  // absent: start and end of the motion
  std::optional<double> still;     // time of a single picture; absent: `from`
  bool one_picture = false;        // true: a single picture, at `still`, else at `from`
};

// The times of the frames. Film time counts from the start of the whole film, motion time from the
// start of the motion; `timeline` converts between them.
struct FrameTimes {
  Timeline timeline;   // of the whole film; panels in turn begin where the motion before them ends
  double first = 0.0;  // s of film: time of frame 0
  double rate = 60.0;  // frames per second of film
  int count = 1;       // number of frames; 1 for a single picture
  double from = 0.0, to = 0.0;    // s of motion: what the frames cover; equal for one picture
  std::optional<Loop> loop = {};  // how well a looping film closes; absent: it does not loop

  // The film time (s) that a frame shows; the first frame has the index 0.
  double film_time(int index) const { return first + index / rate; }
  // The first frame at or after a film time (s): negative before what the frames cover, their
  // number behind it.
  int frame_at(double film) const;
  // The motion from one frame to the next, s, where the story does not hold it.
  double motion_step() const { return timeline.time_scale() / rate; }
};

// The story, or one with the same steps in other words, as the whole film tells it: once for each
// panel, if these follow one another.
std::vector<StoryStep> story_of_film(const Scene& scene, const std::vector<StoryStep>& story);

// Checks what can be checked before the motion is computed. Throws Error (input) with --from, --to
// or --still as key for a time outside the motion or in the wrong order, and without a place for
// more than 1e7 frames.
void check_time_range(const Scene& scene, const TimeRange& range);

// The frame times of a range that check_time_range accepts. A looping film ends where the motion is
// back at its start, and its time scale is changed a little so that the loop has a whole number of
// frames. Throws Error (input) with story[i].at, --from, --to or --still as key for a step or a
// time after the end of the motion or of the loop (the message says where it closes), and without a
// place for more than 1e7 frames; (check_failed) as find_loop does.
FrameTimes plan_frame_times(const Solved& solved, const TimeRange& range);

// What a film with these frame times is about: of one that repeats, the motions until its end.
Solved shown_part(Solved solved, const FrameTimes& frames);

}  // namespace polhode
