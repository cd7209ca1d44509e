// SPDX-License-Identifier: MIT
// One-step methods for dy/dt = y x w + gamma x chi, dq/dt = q o (0, w)/2, and the table of them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/body_model.h"

namespace polhode {

// What stepping has cost so far.
struct Work {
  long evaluations = 0;  // of the right-hand side, of residuals, of partial flows
};

// A method applied to one model. Steps of any length and sign, each a function of the state alone;
// immutable, so one may step many trajectories, from any thread, and allocates nothing.
class Stepper {
 public:
  virtual ~Stepper() = default;
  // Advances s from t by h. Throws Error (check failed) when an implicit solve finds no solution.
  virtual void step(double t, double h, State& s, Work& work) const = 0;
  void step(double t, double h, State& s) const {
    Work uncounted;
    step(t, h, s, uncounted);
  }
  // The same for an adaptive method; returns an estimate of the local error: the larger of
  // |error of q| and |error of y| / momentum_scale.
  virtual double step_with_error(double t, double h, State& s, Work& work) const;
};

// What a limit of the step is a limit of: nothing, how far the angular momentum goes round in the
// body in a step, or how far the body turns.
enum class StepLimit { none, oscillation, spin };

// One row per method. To add one: its file in motion/steppers/, and a row in stepper.cpp. Help,
// names and the test kit derive from this table.
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

// "" when the method can step the model, else the reason why not, and which methods can.
std::string why_not(const StepperInfo& method, const BodyModel& model);

}  // namespace polhode
