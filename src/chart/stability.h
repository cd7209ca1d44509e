// SPDX-License-Identifier: MIT
// Classifies one run of a method with a given step: accurate, or how it fails. Stability maps
// consist of such runs.
#pragma once

#include <string>
#include <vector>

#include "chart/reference_solution.h"
#include "motion/stepper_table.h"

namespace polhode {

// How a run ends.
enum class RunOutcome {
  fine,
  phase_wrong,    // error above the allowed one, with the right kind of motion
  flips_wrongly,  // the axis points the opposite way from the reference
  energy_grows,   // energy rises by more than 2% of its scale
  energy_decays,  // energy falls by more than that
  solver_failed,  // an implicit step has no solution
  not_a_number,
};
inline constexpr int kRunOutcomes = 7;

// "fine", "phase_wrong", and so on.
const char* name_of(RunOutcome outcome);
// The outcome of that name. Throws Error (input), without a key, for any other text.
RunOutcome parse_run_outcome(const std::string& name);

// A motion to test methods on, with its reference solution.
struct StabilityProblem {
  StabilityProblem(const BodyModel& model, const State& start, double duration);

  BodyModel model;
  State start;
  double duration;  // s
  ReferenceSolution reference;
};

// The result of one run. Unknown numbers are NaN.
struct StabilityCell {
  RunOutcome outcome = RunOutcome::fine;
  double error_rad = 0.0;
  double energy_drift = 0.0;    // signed; relative as in motion/trajectory.h
  double momentum_drift = 0.0;  // relative as there
};

// Runs the method with steps h (s) over the whole motion. The outcome is `fine` if the attitude
// error stays below allowed_rad or, without a usable reference, if energy and momentum drift by at
// most 1e-3. Throws Error (interrupted) only. Thread-safe.
StabilityCell try_method(const StepperInfo& method,
                         const StabilityProblem& problem,
                         double h,
                         double allowed_rad);

}  // namespace polhode
