// SPDX-License-Identifier: MIT
// The table of one-step methods.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/stepper.h"

namespace polhode {

// What a limit of the step is a limit of: nothing, how far the angular momentum goes round in the
// body in a step, or how far the body turns.
enum class StepLimit { none, oscillation, spin };

// One row per method. To add one: its file in motion/steppers/, and a row in stepper_table.cpp.
// Help, names and the test kit derive from this table.
struct StepperInfo {
  std::string name = {};
  std::string title = {};  // for people, in pictures
  int order = 0;
  bool adaptive = false;
  bool keeps_energy = false;          // to round-off, whatever the step
  bool keeps_momentum_norm = false;   // |y| of a free body
  bool keeps_momentum_space = false;  // L in space of a free body, L.up of a heavy one
  bool symplectic = false;            // keeps the canonical form of (q, y)
  bool reversible = false;            // a step back undoes a step, to round-off
  bool exact_when_free = false;       // no error but round-off without gravity
  bool takes_heavy = false;           // gravity on a pivot
  bool takes_loads = false;           // torques and forces besides, six degrees of freedom
  bool takes_rotator = false;         // bodies with all mass on a line
  std::string cost = {};              // of a step
  std::string limit = {};             // of the step, where theory gives one; else empty
  StepLimit limit_of = StepLimit::none;
  double limit_turn = 0.0;  // rad; see motion/step_limit.h
  std::string source = {};  // where it comes from
  // momentum_scale: a typical |y|, kg m^2/s, for the error norm
  std::unique_ptr<Stepper> (*make)(const BodyModel& model, double momentum_scale) = nullptr;
};

const std::vector<StepperInfo>& stepper_table();

// The row of that name. Throws Error (input) naming the nearest one.
const StepperInfo& find_stepper(const std::string& name);

// The methods of a list such as "rk4,dop853", all of them for "". Throws Error (input), naming
// --methods.
std::vector<const StepperInfo*> parse_methods(const std::string& names);

// "" when the method can step the model, else the reason why not, and which methods can.
std::string why_not(const StepperInfo& method, const BodyModel& model);

}  // namespace polhode
