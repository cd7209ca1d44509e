// SPDX-License-Identifier: MIT
// The interface of one-step methods for dy/dt = y x w + gamma x chi + loads, dq/dt = q o (0, w)/2
// (letters: math/notation.h and model/body_model.h).
#pragma once

#include <array>
#include <limits>
#include <memory>

#include "model/body_model.h"

namespace polhode {

// Counts the cost of stepping.
struct Work {
  long evaluations = 0;  // of the right-hand side, of residuals, of partial flows
};

// Where an adaptive method is and how it goes on: a step of length h (s) from t, to `end` at most,
// with errors of at most `tolerance`. Number: double, or the lanes of a register.
template <class Number>
struct AdaptivePace {
  Number t, h, end, tolerance;

  // the end of the step
  [[gnu::always_inline]] Number next() const { return t + h < end ? t + h : end; }
  // tolerance over the error of a step; its root of the order says how long steps may be. 0 where
  // the step was so long that its error is no number.
  [[gnu::always_inline]] Number ratio(const Number& error) const {
    const Number found = tolerance / (error < 1e-300 ? Number{} + 1e-300 : error);
    return error < std::numeric_limits<double>::infinity() ? found : Number{};
  }
  // Standard controller: aim at 0.9^order of the tolerance, never jump by more than five. The
  // length of a step that replaces one to `next`, where it can be shorter and more than round-off.
  [[gnu::always_inline]] Number shortened(const Number& next, const Number& root) const {
    return (next - t) * clamped(0.9 * root, 0.1, 0.9);
  }
  [[gnu::always_inline]] auto can_shorten(const Number& next, const Number& root) const {
    const Number to = t + shortened(next, root);
    return (to > t) & (to < next);
  }
  // of the step after one to `next`; a step that was cut short says little of it
  [[gnu::always_inline]] Number after(const Number& next, const Number& root) const {
    const Number proposed = (next - t) * clamped(0.9 * root, 0.2, 5.0);
    return ((next == end) & (proposed < h)) ? h : proposed;
  }

 private:
  [[gnu::always_inline]] static Number clamped(const Number& x, double low, double high) {
    const Number a = Number{} + low, b = Number{} + high;
    return x < a ? a : (b < x ? b : x);
  }
};

// A few steps of an adaptive method with three degrees of freedom.
struct Stretch {
  static constexpr int kMost = 8;
  struct Step {
    double t;                 // s, where it ends
    std::array<double, 7> v;  // StateVector there (motion/steppers/derivative.h)
  };
  AdaptivePace<double> pace;  // advanced to where the next stretch begins
  std::array<Step, kMost> steps;
  int count = 0;  // accepted steps
  int tried = 0;  // these and others
};

// A part of h (s) of a step of `whole` (s) from the time t (s), which advances s.
struct Leap {
  double t, h, whole;
  State* s;
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
  // Advances s to what the method says of a moment within a step of `whole` (s), h after its
  // beginning at the time t: by default what a step of h gives.
  virtual void step_within(double t, double h, double whole, State& s) const;
  // The same, and where that has no solution, as several shorter parts, one after the other. Throws
  // Error as step() does.
  void part_of_step(double t, double h, double whole, State& s) const;
  // Takes `count` such parts of steps that have nothing to do with each other.
  virtual void leap(const Leap* leaps, int count) const;
  // For adaptive methods only; aborts for others. Does the same as step() and returns an estimate
  // of the local error, the larger of |error of q| and |error of y| / momentum_scale()
  // (motion/scales.h; with six degrees of freedom also the scaled errors of place and linear
  // momentum, see ErrorNorm in motion/steppers/derivative.h).
  virtual double step_with_error(double t, double h, State& s, Work& work) const;
  // For adaptive methods: takes the next steps from s, each as step_with_error() would, together
  // with other motions (motion/convoy.h). False: this method or this thread has none; or none of
  // the steps could be taken, and step_with_error() tells why. Then nothing was changed.
  virtual bool walk_in_convoy(const State&, Stretch&, Work&) const { return false; }
};

}  // namespace polhode
