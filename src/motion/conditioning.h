// SPDX-License-Identifier: MIT
// How far one rounding of the start moves a motion: what no method can do better than.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "motion/solution_method.h"
#include "motion/trajectory.h"

namespace polhode {

// Starts next to a start, and how far from it they are.
struct Neighbours {
  std::vector<State> starts;
  double size = 0.0;  // of the momentum a fraction, of the attitude rad
};

// Six neighbours: each component of the momentum (P) changed by the fraction `size` of itself, and
// the attitude turned by `size` about each principal axis.
Neighbours neighbours_of(const State& start, double size);

// One neighbour: each component of the momentum changed by the fraction `size` of momentum_scale()
// (motion/scales.h), and the attitude turned by `size` about all three principal axes.
Neighbours one_neighbour_of(const BodyModel& model, const State& start, double size);

// What roundings (2^-53 each) of the start do to the motion.
struct Conditioning {
  double effect = 0.0;       // rad: largest change of the attitude over the motion
  double exceeded_at = 0.0;  // s: first time found at which the change exceeds the limit, else 0
  bool exceeds_limit = false;
};

// Compares `motion` with the motions of its neighbours, which `solve` finds in the same way as
// `motion` was found. The change is scaled from the distance of the neighbours to that of so many
// `roundings`; it must be small for this to be true. `limit` in rad, duration in s. Throws what
// `solve` throws.
Conditioning conditioning_of(
    const BodyModel& model,
    const Trajectory& motion,
    double duration,
    const Neighbours& neighbours,
    double roundings,
    double limit,
    const std::function<std::shared_ptr<const Trajectory>(const State& start)>& solve);

// The same of a closed form that `method` has made from `start`: what one rounding of the start
// does to it.
Conditioning conditioning_of_closed_form(const SolutionMethod& method,
                                         const BodyModel& model,
                                         const State& start,
                                         const Trajectory& motion,
                                         double duration,
                                         double limit);

}  // namespace polhode
