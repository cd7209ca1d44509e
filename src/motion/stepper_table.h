// SPDX-License-Identifier: MIT
// The table of one-step methods.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/stepper.h"

namespace polhode {

// The angle per step that a method limits: none, the angle by which the angular momentum circles in
// the body, or the angle by which the body turns.
enum class StepLimit { none, oscillation, spin };

// What methods have in common, and share a colour in charts.
enum class MethodFamily {
  engines,        // of game engines, and kept to show how they fail
  runge_kutta,    // explicit
  taylor,         // series of high order
  implicit,       // Runge-Kutta methods that solve for their stages
  lie_group,      // exponentials of rotations
  rotations,      // compositions of turns about axes of the body
  moser_veselov,  // discrete mechanics
  kicks,          // exact free motions between kicks of gravity
  table,          // of a body on a table without events, and kept to show how they fail
};
// its name in lists, such as "Runge-Kutta"
std::string family_title(MethodFamily family);

// One row per method. To add one: its file in motion/steppers/, and a row in stepper_table.cpp.
// Help, names and the test kit derive from this table.
struct StepperInfo {
  std::string name = {};   // value of numerics.method
  std::string title = {};  // for charts
  MethodFamily family = MethodFamily::engines;
  int order = 0;                      // the error of a motion is proportional to (step)^order
  bool adaptive = false;              // estimates its error and takes a tolerance; else fixed steps
  bool keeps_energy = false;          // to round-off, whatever the step
  bool keeps_momentum_norm = false;   // |y| of a free body
  bool keeps_momentum_space = false;  // L in space of a free body, L.up of a heavy one
  bool symplectic = false;            // keeps the canonical form of (q, y)
  bool reversible = false;            // a step by -h undoes a step by h, to round-off
  bool exact_when_free = false;       // exact to round-off for a free body, whatever the step
  bool stiff = false;                 // L-stable: strong damping does not limit its step
  bool takes_heavy = false;           // gravity on a pivot
  bool takes_loads = false;           // other torques and forces, and six degrees of freedom
  bool takes_table = false;           // bodies on a table
  bool only_table = false;            // and no others; without events
  bool takes_rotator = false;         // bodies with all mass on a line
  bool takes_bounces = false;         // with only_table: falls that give back speed
  std::string cost = {};              // of a step, as text
  std::string limit = {};             // of the step, as text; empty: theory gives none
  StepLimit limit_of = StepLimit::none;
  double limit_turn = 0.0;  // the greatest angle of that kind per step, rad
  std::string source = {};  // paper or book
  // Applies the method to a model, of which it keeps copies. Call it only if why_not() is empty:
  // otherwise loads or gravity may be ignored. momentum_scale: a typical |y| for the error norm, kg
  // m^2/s.
  std::unique_ptr<Stepper> (*make)(const BodyModel& model, double momentum_scale) = nullptr;
};

// All methods; the table exists until the program ends, and so do the references and pointers
// below.
const std::vector<StepperInfo>& stepper_table();

// The row of that name. Throws Error (input), without a key, that suggests the nearest name.
const StepperInfo& find_stepper(const std::string& name);

// The methods of a list such as "rk4,dop853", in its order and each once, or all methods for "".
// Throws Error (input), naming --methods, for an unknown or empty name.
std::vector<const StepperInfo*> parse_methods(const std::string& names);

// Tells why a method cannot integrate a model; "" if it can.
using MethodObstacle = std::string (*)(const StepperInfo& method, const BodyModel& model);
// "" if the method can integrate the model, else the reason why not and the names of methods that
// can.
std::string why_not(const StepperInfo& method, const BodyModel& model);
// Likewise with steps that are given: an adaptive method that goes from event to event on a table
// has none.
std::string why_not_by_fixed_steps(const StepperInfo& method, const BodyModel& model);

}  // namespace polhode
