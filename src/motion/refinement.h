// SPDX-License-Identifier: MIT
// Refines an integration until the error of its answer is below a given accuracy.
#pragma once

#include <optional>

#include "motion/conditioning.h"
#include "motion/grid_trajectory.h"

namespace polhode {

// The tolerances of successive runs differ by this factor; steps by two.
inline constexpr double kTolerancesApart = 32.0;

// The fineness of an integration is the step (s) of a fixed-step method, and the tolerance of an
// adaptive one. A body on a table is integrated from event to event. Throws Error as
// integrate_fixed and integrate_adaptive do.
Integration integrate_with(const StepperInfo& method,
                           const BodyModel& model,
                           const State& start,
                           double duration,
                           double fineness,
                           const Effort& effort = {});

// Is told now and then which run, from 1, is how far (part of the duration).
using SimulationWatch = std::function<void(int run, double part)>;

// An integration whose error was estimated.
struct Refined {
  Integration integration;
  double fineness = 0.0;  // s, or relative tolerance
  // rad: truncation and round-off of this integration's attitude over the whole motion
  double error_estimate = 0.0;
  // what round-off may do to it; it may exceed the accuracy
  Conditioning conditioning;
};

// Makes runs of increasing fineness until the estimated error of the last one is at most
// `accuracy` (rad). The estimate needs three runs: the differences of successive runs must fall as
// the order of the method demands; a smaller difference is taken for chance. The last difference
// must be clearly below the accuracy, too. Each pair of runs is compared at times that no other
// pair was compared at. duration in s. Throws Error (input), without a key, if the accuracy cannot
// be reached: because the runs stop converging before, as they do where round-off has grown too
// much, or because a run needs more than `most_steps`. Throws Error as integrate_with and `watch`
// do. `likely` is a fineness that will probably do, which the third run has.
Refined refine(const StepperInfo& method,
               const BodyModel& model,
               const State& start,
               double duration,
               double accuracy,
               long most_steps,
               const SimulationWatch& watch = {},
               std::optional<double> likely = {});

}  // namespace polhode
