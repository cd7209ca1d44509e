// SPDX-License-Identifier: MIT
// How far one rounding of the start moves a motion: what no method can do better than.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "motion/trajectory.h"

namespace polhode {

// The starts next to `start`: each component of the momentum (P) changed by the fraction `size`,
// and the attitude turned by `size` (rad) about each principal axis.
std::vector<State> neighbours_of(const State& start, double size);

// One start next to `start`, with all six changes at once.
State neighbour_of(const State& start, double size);

// What one rounding (2^-53) of the start does.
struct Conditioning {
  double effect = 0.0;       // rad: largest change of the attitude over the motion
  double exceeded_at = 0.0;  // s: first time found at which the change exceeds the limit
  bool exceeds_limit = false;
};

// Compares `motion` with the motions of its neighbours, which `solve` finds in the same way as
// `motion` was found. Their distance (`size` in neighbours_of) may be larger than a rounding, as
// long as the change stays small: it is scaled. `limit` in rad, duration in s. Throws what `solve`
// throws.
Conditioning conditioning_of(
    const BodyModel& model,
    const Trajectory& motion,
    double duration,
    const std::vector<State>& neighbours,
    double size,
    double limit,
    const std::function<std::shared_ptr<const Trajectory>(const State& start)>& solve);

}  // namespace polhode
