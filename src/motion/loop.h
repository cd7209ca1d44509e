// SPDX-License-Identifier: MIT
// Where a motion comes back to its start, so that its film can repeat without a jump.
#pragma once

#include "motion/motion.h"

namespace polhode {

// A duration after which the motion is nearly as at its start.
struct Loop {
  double duration = 0.0;  // s
  double residual = 0.0;  // rad: how far attitude and angular velocity (in body axes, relative to
                          // its size) are off there
};

// The shortest duration up to `longest` (s) that closes spin, precession and nutation to within
// `allowed` rad; if there is none, the one that closes best. Every turn of the body is looked at,
// so nothing is assumed of the kind of motion.
Loop find_loop(const Motion& motion, double longest, double allowed);

}  // namespace polhode
