// SPDX-License-Identifier: MIT
// The stepping loops that trajectories and charts share. They store no states and allocate no
// memory.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "motion/stepper_table.h"

namespace polhode {

// The cost of a walk.
struct WalkRecord {
  long steps = 0;
  long rejected = 0;  // steps of an adaptive method that were repeated with a shorter step
  Work work;
};

// Whether every number of the state is finite.
bool is_finite(const State& s);
// Throws Error (check_failed), with method and time t (s) in the message, if the state is not
// finite.
void refuse_nan(const State& s, const StepperInfo& method, double t);
// An Error (check_failed): the steps of an adaptive method fell below round-off.
class StepTooSmall final : public Error {
 public:
  using Error::Error;
};
// Throws StepTooSmall, for this tolerance at t (s).
[[noreturn]] void refuse_tolerance(const StepperInfo& method, double tolerance, double t);

// x^(1/order). Roots of the eighth order are taken as square roots, which every processor rounds
// alike, and which registers can take in all their lanes.
inline double root_of(double x, int order) {
  return order == 8 ? std::sqrt(std::sqrt(std::sqrt(x))) : std::pow(x, 1.0 / order);
}

// How far to step from t (s) at most: to just before the next switch or, from there, to just behind
// it. Advances `ahead`, the first switch that is not yet behind t.
inline double end_of_smooth_part(double t,
                                 std::vector<double>::const_iterator end,
                                 std::vector<double>::const_iterator& ahead) {
  constexpr double kNear = 4.0 * std::numeric_limits<double>::epsilon();
  while (ahead != end && t >= *ahead * (1.0 + kNear))
    ++ahead;
  if (ahead == end) return std::numeric_limits<double>::infinity();
  const double before = *ahead * (1.0 - kNear);
  return t < before ? before : *ahead * (1.0 + kNear);
}

// Takes `steps` steps of h (s) from time 0, starting from s, which is advanced to the end. Calls
// visit(i, s) with the state after step i = 1, 2, ... States that are not finite are not refused.
// Throws what the stepper and `visit` throw.
template <class Visit>
WalkRecord walk_fixed(const Stepper& stepper, State& s, double h, long steps, Visit&& visit) {
  WalkRecord record;
  for (long i = 0; i < steps; ++i) {
    stepper.step(static_cast<double>(i) * h, h, s, record.work);
    visit(i + 1, s);
  }
  record.steps = steps;
  return record;
}

// Steps from time 0 to duration (s), starting from s, which is advanced to the end, with estimated
// local errors of at most `tolerance`. `first` (s) is the first step to try. method.adaptive;
// tolerance and `first` are positive. If it throws, s is the last accepted state. `stepper` is an
// instance of `method`. Calls visit(t, s) with the state after every accepted step. Throws Error
// (check_failed) if the state is not finite or the step falls below round-off, and what the stepper
// and `visit` throw. `switches` (s, in order) are times at which the right-hand side jumps or has a
// kink: a step ends just before each, and a tiny one leads across.
template <class Visit>
WalkRecord walk_adaptive(const StepperInfo& method,
                         const Stepper& stepper,
                         State& s,
                         double duration,
                         double tolerance,
                         double first,
                         const std::vector<double>& switches,
                         Visit&& visit) {
  WalkRecord record;
  AdaptivePace<double> pace{0.0, std::min(first, duration), duration, tolerance};
  auto ahead = switches.begin();
  const auto accept = [&](double t, const State& now) {
    refuse_nan(now, method, t);
    s = now;
    ++record.steps;
    visit(t, s);
  };
  while (pace.t < duration) {
    pace.end = std::min(duration, end_of_smooth_part(pace.t, switches.end(), ahead));
    State trial = s;
    Stretch stretch;
    stretch.pace = pace;
    if (stepper.walk_in_convoy(s, stretch, record.work) && stretch.tried > 0) {
      record.rejected += stretch.tried - stretch.count;
      pace = stretch.pace;
      for (int i = 0; i < stretch.count; ++i) {
        const Stretch::Step& step = stretch.steps[static_cast<std::size_t>(i)];
        trial.q = Quat(step.v[3], step.v[0], step.v[1], step.v[2]);
        trial.y = Vec3(step.v[4], step.v[5], step.v[6]);
        accept(step.t, trial);
      }
      continue;
    }
    const double next = pace.next();
    const double error = stepper.step_with_error(pace.t, next - pace.t, trial, record.work);
    const double root = root_of(pace.ratio(error), method.order);
    if (!(error <= tolerance)) {
      ++record.rejected;
      // a step of one rounding of the time cannot be shortened
      if (!pace.can_shorten(next, root)) {
        refuse_nan(trial, method, next);
        refuse_tolerance(method, tolerance, pace.t);
      }
      pace.h = pace.shortened(next, root);
      continue;
    }
    pace.h = pace.after(next, root);
    pace.t = next;
    accept(next, trial);
  }
  return record;
}

}  // namespace polhode
