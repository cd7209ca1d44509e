// SPDX-License-Identifier: MIT
// Classifies one run of a method with a given step: accurate, or how it fails. Stability maps
// consist of such runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chart/reference_solution.h"
#include "motion/stepper_table.h"

namespace polhode {

// How a run ends. Which way a body points is the cosine between the upward vertical and the
// direction from the fixed point to the centre of mass or, without a torque of gravity, between the
// angular momentum and the principal axis to which it is closest at the start. It counts as
// opposite if the signs differ and both cosines exceed 0.3 in size.
//
// A run with too large an error has the first of these outcomes that applies: energy_grows,
// energy_decays, flips_wrongly, phase_wrong. Energy grows or decays if it drifts by more than 2% of
// its scale; the sign is that of the drift at the end.
enum class RunOutcome {
  fine,           // the error is within the allowed one
  phase_wrong,    // too large an error, but none of the failures below
  flips_wrongly,  // at some time the body points the opposite way from the reference, and its
                  // attitude is off by more than a right angle
  energy_grows,
  energy_decays,
  solver_failed,  // a step has no solution (Stepper::step)
  not_a_number,   // the state became NaN or infinite
  unchecked,      // it came to its end, and there is nothing to hold it against
};
inline constexpr int kRunOutcomes = 8;  // number of outcomes

// The name as it is spelled above: "fine", "phase_wrong", and so on.
const char* name_of(RunOutcome outcome);
// The outcome of that name; absent for any other text.
std::optional<RunOutcome> find_run_outcome(const std::string& name);

// A motion to test methods on, with its reference solution.
struct StabilityProblem {
  // Computes the reference; `duration` in s, positive. Throws Error (interrupted).
  StabilityProblem(const BodyModel& model, const State& start, double duration);

  BodyModel model;
  State start;
  double duration;  // s, from t = 0
  ReferenceSolution reference;
};

// The result of one run. Drifts are relative, see Drift in motion/trajectory.h. Unknown numbers are
// NaN: all if the run failed (solver_failed, not_a_number), the error if the reference is unusable
// or the energy exploded, a drift if the loads do not conserve the quantity.
struct StabilityCell {
  RunOutcome outcome = RunOutcome::fine;
  double error_rad = 0.0;       // largest deviation() from the reference (motion/deviation.h), rad
  double energy_drift = 0.0;    // largest Drift::energy, with the sign of the drift at the end
  double momentum_drift = 0.0;  // largest Drift::momentum
};

// Runs the method with fixed steps h (s, positive) over the whole motion and looks at it at the
// times of the reference. The outcome is `fine` if the deviation never exceeds allowed_rad or,
// without a usable reference, if energy and momentum, where the loads conserve them, drift by at
// most 1e-3, and `unchecked` if they conserve neither. A run whose energy drift exceeds 1e6 is
// ended as energy_grows. The method must be able to integrate the model so
// (why_not_by_fixed_steps() in motion/stepper_table.h). Throws Error (interrupted) only.
// Thread-safe.
StabilityCell try_method(const StepperInfo& method,
                         const StabilityProblem& problem,
                         double h,
                         double allowed_rad);

}  // namespace polhode
