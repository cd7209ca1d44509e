// SPDX-License-Identifier: MIT
// A trajectory found by stepping, once, over a grid of times that no frame rate knows of.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/stepper_table.h"
#include "motion/trajectory.h"

namespace polhode {

// What an integration cost and how well it kept what is conserved.
struct IntegrationRecord {
  long steps = 0;
  long rejected = 0;     // steps that an adaptive method tried and gave up
  long evaluations = 0;  // of the right-hand side
  Drift drift;
};

struct Integration {
  std::shared_ptr<const Trajectory> trajectory;
  IntegrationRecord record;
};

// The most steps of one integration; more is an input error that says so.
inline constexpr long kMostSteps = 50'000'000;

// The least tolerance of an adaptive method: relative, the round-off of one step.
inline constexpr double kLeastTolerance = 1e-16;

// Fixed steps h from 0 to duration. Between grid times the answer is one partial step from the grid
// time before: as exact as the method, and on the unit sphere. Memory is bounded: every k-th state
// is kept and at() walks fewer than k steps. Throws Error (check failed) with the time when a step
// has no solution or a state is not a number.
Integration integrate_fixed(const StepperInfo& method,
                            const BodyModel& model,
                            const State& start,
                            double duration,
                            double h);

// Steps whose estimated local error stays below `tolerance` (see Stepper::step_with_error). Throws
// Error (input) for a tolerance below kLeastTolerance.
Integration integrate_adaptive(const StepperInfo& method,
                               const BodyModel& model,
                               const State& start,
                               double duration,
                               double tolerance);

}  // namespace polhode
