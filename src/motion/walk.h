// SPDX-License-Identifier: MIT
// The stepping loops that trajectories and charts share. They store no states and allocate no
// memory.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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
// Throws Error (check_failed) that says that at t (s) the step of an adaptive method fell below
// round-off with this tolerance.
[[noreturn]] void refuse_tolerance(const StepperInfo& method, double tolerance, double t);

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
  double h = std::min(first, duration);
  double t = 0.0;
  auto ahead = switches.begin();
  while (t < duration) {
    const double end = std::min(duration, end_of_smooth_part(t, switches.end(), ahead));
    const double next = t + h < end ? t + h : end;
    State trial = s;
    const double error = stepper.step_with_error(t, next - t, trial, record.work);

    // standard controller: aim at 0.9^order of the tolerance, never jump by more than five
    const double ratio = std::pow(tolerance / std::max(error, 1e-300), 1.0 / method.order);
    if (!(error <= tolerance)) {
      ++record.rejected;
      h = (next - t) * std::clamp(0.9 * ratio, 0.1, 0.9);
      // a step of one rounding of the time cannot be shortened
      if (!std::isfinite(h) || t + h == t || t + h >= next) {
        refuse_nan(trial, method, next);
        refuse_tolerance(method, tolerance, t);
      }
      continue;
    }
    refuse_nan(trial, method, next);
    // a step that a switch cut short says little of the next
    const double proposed = (next - t) * std::clamp(0.9 * ratio, 0.2, 5.0);
    h = next == end ? std::max(h, proposed) : proposed;
    t = next;
    s = trial;
    ++record.steps;
    visit(t, s);
  }
  return record;
}

}  // namespace polhode
