// SPDX-License-Identifier: MIT
// Finds a duration after which a motion is back at its start, so that a film can repeat without a
// visible jump.
#pragma once

#include "motion/motion.h"

namespace polhode {

// A duration after which the motion is nearly back at its start.
struct Loop {
  double duration = 0.0;  // s
  // rad: difference from the start, in attitude and in w_B relative to its size
  double residual = 0.0;
};

// The shortest duration up to `longest` (s) with a residual of at most `allowed` (rad), so that
// spin, precession and nutation all close. If there is none, the duration with the smallest
// residual. `longest` with residual 0 for a body at rest. The search samples the motion every tenth
// of a radian of its fastest rotation and assumes nothing about the kind of motion.
Loop find_loop(const Motion& motion, double longest, double allowed);

}  // namespace polhode
