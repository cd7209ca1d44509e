// SPDX-License-Identifier: MIT
// One-step methods for dy/dt = y x w + gamma x chi, dq/dt = q o (0, w)/2.
#pragma once

#include <memory>

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

}  // namespace polhode
