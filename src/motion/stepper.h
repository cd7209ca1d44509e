// SPDX-License-Identifier: MIT
// The interface of one-step methods for dy/dt = y x w + gamma x chi + loads, dq/dt = q o (0, w)/2
// (letters: math/notation.h and model/body_model.h).
#pragma once

#include <memory>

#include "model/body_model.h"

namespace polhode {

// Counts the cost of stepping.
struct Work {
  long evaluations = 0;  // of the right-hand side, of residuals, of partial flows
};

// A method applied to one model. Takes steps of any length but zero and of any sign; the result
// depends on the arguments only. Immutable, so threads may share it. A step does not allocate
// memory, except that of the kick methods if it turns an asymmetric body by more than 8 rad
// (motion/steppers/free_flow.cpp).
class Stepper {
 public:
  virtual ~Stepper() = default;
  // Advances s from the time t by h (both in s), and adds its cost to `work`; s.q stays of unit
  // length. Throws Error (check_failed) if an implicit step has no solution, and, with Euler
  // angles, near tilts of 0 and 180 degrees.
  virtual void step(double t, double h, State& s, Work& work) const = 0;
  void step(double t, double h, State& s) const {
    Work uncounted;
    step(t, h, s, uncounted);
  }
  // For adaptive methods only; aborts for others. Does the same as step() and returns an estimate
  // of the local error, the larger of |error of q| and |error of y| / momentum_scale()
  // (motion/scales.h; with six degrees of freedom also the scaled errors of place and linear
  // momentum, see ErrorNorm in motion/steppers/derivative.h).
  virtual double step_with_error(double t, double h, State& s, Work& work) const;
};

}  // namespace polhode
