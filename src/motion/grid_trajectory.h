// SPDX-License-Identifier: MIT
// A trajectory that is integrated once, on a time grid that does not depend on the frame rate.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "motion/motion_spec.h"
#include "motion/stepper_table.h"
#include "motion/trajectory.h"

namespace polhode {

// Something that changed how a body touches its table.
struct ContactRecord {
  double t = 0.0;     // s
  std::string event;  // a name, such as "slip_ends"
  std::string words;  // a phrase
};
// At most so many are recorded.
inline constexpr std::size_t kEventsReported = 1000;

// What an integration cost, and how well it kept the conserved quantities.
struct IntegrationRecord {
  long steps = 0;
  long rejected = 0;     // steps of an adaptive method that were repeated with a shorter step
  long evaluations = 0;  // as Work counts them
  Drift drift;           // the largest over the grid times and, of few steps, within them
  std::vector<ContactRecord> events = {};  // on a table, in order
  double left_out_rad = 0.0;  // of the motion of a body that is laid on a face (ContactChange)
};

// A trajectory (never null) and its record.
struct Integration {
  std::shared_ptr<const Trajectory> trajectory;
  IntegrationRecord record;
};

// The least relative tolerance of an adaptive method: about the round-off of one step.
inline constexpr double kLeastTolerance = 1e-16;

// What a run may cost, and whom it tells how far it is.
struct Effort {
  long most_steps = kMostSteps;
  long likely_steps = 0;  // of an adaptive method, for which memory is reserved; 0: unknown
  // called now and then with the part of the duration that is done; may be empty
  std::function<void(double part)> watch = {};
};

// The error of an integration that needs about `needed` steps and may take `most`.
Error too_many_steps(const StepperInfo& method, double duration, double needed, long most);

// Fixed steps h (s, positive) from 0 to the last multiple of h within duration (s, positive). From
// one grid time to the next and after the last one, at() makes one partial step from the preceding
// grid time (several where that has no solution, Stepper::part_of_step), so it is as accurate as
// the method and returns unit quaternions. Memory is bounded: every k-th state is kept (at most
// about 100,000), and at() repeats fewer than k steps. The method must be able to integrate the
// model (why_not). Throws Error (input), without a key, for more than kMostSteps or
// effort.most_steps; (check_failed), with the time in the message, if a step has no solution or a
// state is not finite; (interrupted).
Integration integrate_fixed(const StepperInfo& method,
                            const BodyModel& model,
                            const State& start,
                            double duration,
                            double h,
                            const Effort& effort = {});

// Steps whose estimated local error is at most `tolerance` (positive; see
// Stepper::step_with_error), from 0 to duration (s). at() is as for integrate_fixed. Requires
// method.adaptive, and that the method can integrate the model. Throws Error (check_failed) as
// walk_adaptive does, (interrupted), and (input), without a key, for a tolerance below
// kLeastTolerance and for more than kMostSteps / 8 or effort.most_steps steps.
Integration integrate_adaptive(const StepperInfo& method,
                               const BodyModel& model,
                               const State& start,
                               double duration,
                               double tolerance,
                               const Effort& effort = {});

}  // namespace polhode
