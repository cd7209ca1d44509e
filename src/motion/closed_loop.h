// SPDX-License-Identifier: MIT
// Finds a duration after which a motion is back at its start, so that a film can repeat without a
// visible jump.
#pragma once

#include "motion/motion.h"

namespace polhode {

// A duration after which the motion is nearly back at its start.
struct Loop {
  double duration = 0.0;  // s
  // Difference from the start: the angle between the attitudes (rad) and |change of w_B| / |w_B|,
  // as the root of the sum of their squares. The angle counts in units of the greatest one that
  // there is, if that is below 1 rad: swings of half a degree have not come back at their other
  // end. The divisor is |w_B| at the start, but at least half of its greatest value. Positions do
  // not count.
  double residual = 0.0;
};

// The shortest duration up to `longest` (s, at most that of the motion) at which the residual has a
// minimum of at most `allowed` (positive), so that spin, precession and nutation all close. If
// there is none, the duration with the smallest residual among all minima and `longest`. `longest`
// with residual 0 for a body at rest. The search samples the motion every tenth of a radian of its
// fastest rotation, and of typical_rate() (motion/scales.h), which is that of small swings, but at
// most two million times, and at least a hundred.
// Throws Error (check_failed) as Motion::at does, and (interrupted).
Loop find_loop(const Motion& motion, double longest, double allowed);

}  // namespace polhode
