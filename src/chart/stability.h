// SPDX-License-Identifier: MIT
// Where methods fail: what becomes of one run.
#pragma once

#include <string>
#include <vector>

#include "chart/reference_solution.h"
#include "motion/stepper_table.h"

namespace polhode {

enum class RunOutcome {
  fine,
  phase_wrong,    // the right kind of motion at the wrong time
  flips_wrongly,  // the body points the other way than it should
  energy_grows,
  energy_decays,
  solver_failed,  // an implicit step has no solution
  not_a_number,
};
inline constexpr int kRunOutcomes = 7;

// "fine", "phase_wrong", ...
const char* name_of(RunOutcome outcome);
// The outcome of that name. Throws Error (input).
RunOutcome parse_run_outcome(const std::string& name);

// A motion that methods are tried on, together with its reference solution.
struct StabilityProblem {
  StabilityProblem(const BodyModel& model, const State& start, double duration);

  BodyModel model;
  State start;
  double duration;  // s
  ReferenceSolution reference;
};

// One run and what became of it; numbers that are not known are NaN.
struct StabilityCell {
  RunOutcome outcome = RunOutcome::fine;
  double error_rad = 0.0;
  double energy_drift = 0.0;    // with its sign; relative as in motion/trajectory.h
  double momentum_drift = 0.0;  // relative
};

// Steps of h over the whole motion. Fine: the attitude error stays below `allowed_rad`, or where
// nobody knows the truth, energy and momentum are kept to one in a thousand. Throws Error
// (interrupted) only.
StabilityCell try_method(const StepperInfo& method,
                         const StabilityProblem& problem,
                         double h,
                         double allowed_rad);

}  // namespace polhode
