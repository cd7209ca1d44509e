// SPDX-License-Identifier: MIT
// Chooses the times at which poses are written down, so that what players make of them in between
// stays near the exact motion.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "export/observer.h"

namespace polhode {

// Animation time and motion time. Animations begin at 0.
struct AnimationClock {
  double from = 0.0, to = 0.0;  // the part of the motion that is played, s of motion
  double scale = 1.0;           // s of motion per s of animation

  double duration() const { return (to - from) / scale; }  // s of animation
  double motion_time(double played) const { return std::min(from + scale * played, to); }
};

// A moving thing at its key times.
struct KeyedPoses {
  std::vector<double> times;  // s of animation, ascending; each is a number of single precision
  std::vector<Pose> poses;    // one for each
  double error = 0.0;         // how far playback is from the exact motion, m, as measured
  bool still = false;         // it never moves: there is one pose
};

// How many key times a file may have, of all things: three times those of the largest
// example scene but one, up to 80 MB.
inline constexpr std::size_t kMostKeys = 1'000'000;
// Throws Error (input) if there are more.
void require_few_keys(std::size_t count);

// Times (s of animation) at which everything is looked at first, in single precision: the body
// turns by at most half a radian between them, and what is switched is switched at one of them.
std::vector<double> first_times(const Motion& motion, const AnimationClock& clock);

// The poses at the first times and, where playback would be farther than `tolerance` (m) from the
// exact motion, at times halfway between, again and again. It is tested at the quarters of each
// interval, then measured at other places, where it must not be farther, either. A jump takes a
// hundred-thousandth of the animation, and is not counted as an error. `pose_at`: the exact pose at
// a time of motion. Throws Error (input) if there are more than kMostKeys, and (interrupted).
KeyedPoses keyed(const Thing& thing,
                 const std::function<Pose(double)>& pose_at,
                 const std::vector<double>& first,
                 const AnimationClock& clock,
                 double tolerance);

// About how many key times keyed() finds, from some of the intervals between the first times,
// evenly spread. Ends as soon as it is sure of `enough`. Throws Error (interrupted).
double expected_keys(const Thing& thing,
                     const std::function<Pose(double)>& pose_at,
                     const std::vector<double>& first,
                     const AnimationClock& clock,
                     double tolerance,
                     double enough);

}  // namespace polhode
