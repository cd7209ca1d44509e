// SPDX-License-Identifier: MIT
// The table of solution methods ("models" in scene files: closed forms, splitting, ODE with three
// or six degrees of freedom), and the choice among them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/motion_spec.h"
#include "motion/trajectory.h"

namespace polhode {

// One solution method. To add one: a row in solution_methods(), which is ordered from the simplest
// to the most general.
struct SolutionMethod {
  std::string name;  // value of numerics.model
  std::string doc;   // one phrase, for help
  bool closed_form = false;
  bool with_translation = false;  // integrates the centre of mass too (six degrees of freedom)
  bool on_table = false;          // of a body on a table, with events (motion/contact/)
  bool splits = false;            // splits into exact flows; takes symplectic steppers only
  // "" if it can handle the model, else the reason why not.
  std::string (*why_not)(const BodyModel& model);
  // Makes the trajectory from the state at t = 0; null unless closed_form.
  std::unique_ptr<Trajectory> (*make)(const BodyModel& model, const State& start);
};

// All solution methods; the table exists until the program ends.
const std::vector<SolutionMethod>& solution_methods();

// The method that numerics.model names or, for "auto", the first of the table that can handle the
// model and uses numerics.method, if that is given; but "splitting" only if the cheapest stepper at
// accuracy_rad (motion/method_costs.h) is a splitting. `reason` is set to one phrase that says why.
// Throws Error (input): naming numerics.model if the requested one is unknown or cannot handle the
// model, naming numerics.method if "splitting" is requested with a method that is not symplectic.
const SolutionMethod& choose_solution_method(const BodyModel& model,
                                             const NumericsSpec& numerics,
                                             double accuracy_rad,
                                             std::string& reason);

// Whether the model can be split into kicks and free motions.
bool can_split(const BodyModel& model);

// The model with BodyModel::with_translation set as its loads require.
BodyModel with_needed_degrees(BodyModel model);

}  // namespace polhode
