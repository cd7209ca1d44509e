// SPDX-License-Identifier: MIT
// The steps of an integration with nothing kept of them and nothing allocated: what trajectories,
// charts and maps are made of.
#pragma once

#include <algorithm>
#include <cmath>

#include "motion/stepper_table.h"

namespace polhode {

struct WalkRecord {
  long steps = 0;
  long rejected = 0;  // steps that an adaptive method tried and gave up
  Work work;
};

// Is every number of it finite?
bool is_finite(const State& s);
// Error (check failed) with time and method when the state is not a number.
void refuse_nan(const State& s, const StepperInfo& method, double t);
// Error (check failed): the step of an adaptive method fell to round-off.
[[noreturn]] void refuse_tolerance(const StepperInfo& method, double tolerance, double t);

// `steps` steps of h from time 0. visit(i, s) sees the state after step i = 1, 2, ...
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

// From time 0 to duration in steps whose estimated local error stays below `tolerance`; the first
// step tried is `first`. visit(t, s) sees the state after every step taken. Throws Error (check
// failed) when the state is not a number or the step falls to round-off.
template <class Visit>
WalkRecord walk_adaptive(const StepperInfo& method,
                         const Stepper& stepper,
                         State& s,
                         double duration,
                         double tolerance,
                         double first,
                         Visit&& visit) {
  WalkRecord record;
  double h = std::min(first, duration);
  double t = 0.0;
  while (t < duration) {
    const double next = t + h < duration ? t + h : duration;
    State trial = s;
    const double error = stepper.step_with_error(t, next - t, trial, record.work);

    // standard controller: aim at 0.9^order of the tolerance, never jump by more than five
    const double ratio = std::pow(tolerance / std::max(error, 1e-300), 1.0 / method.order);
    if (!(error <= tolerance)) {
      ++record.rejected;
      h = (next - t) * std::clamp(0.9 * ratio, 0.1, 0.9);
      if (!std::isfinite(h) || t + h == t) {
        refuse_nan(trial, method, next);
        refuse_tolerance(method, tolerance, t);
      }
      continue;
    }
    refuse_nan(trial, method, next);
    h = (next - t) * std::clamp(0.9 * ratio, 0.2, 5.0);
    t = next;
    s = trial;
    ++record.steps;
    visit(t, s);
  }
  return record;
}

}  // namespace polhode
