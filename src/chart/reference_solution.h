// SPDX-License-Identifier: MIT
// The reference solution that numerical runs are compared with.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/trajectory.h"

namespace polhode {

// The states at times spread over a motion, from the closed form or, if there is none, from two
// accurate runs with methods of different kinds. Immutable.
class ReferenceSolution {
 public:
  // duration in s. Throws Error (interrupted) only: if the runs fail, the uncertainty is infinite.
  ReferenceSolution(const BodyModel& model, const State& start, double duration);

  // Where it comes from, as text: "closed form (asymmetric)", "dop853 and kick_srkn11 agree".
  const std::string& source() const { return source_; }
  // The possible error of the reference itself, rad; infinite if the two runs disagree.
  double uncertainty() const { return uncertainty_; }
  // Errors below this (rad) cannot be distinguished from that of the reference: ten times its
  // uncertainty.
  double least_error() const { return 10.0 * uncertainty_; }
  // The times (s), from 0 to the duration, and the states at these times.
  const std::vector<double>& times() const { return times_; }
  const std::vector<State>& states() const { return states_; }
  // The largest deviation() (motion/scales.h) of a run from the reference at these times, rad; NaN
  // if one is NaN.
  double error_of(const Trajectory& run) const;
  // The deviation() of a state from the reference at the end, rad.
  double error_at_end(const State& end) const;

 private:
  void by_closed_form(const State& start);
  void by_two_methods(const State& start);

  BodyModel model_;
  double duration_;
  std::string source_;
  double uncertainty_ = 0.0;
  std::vector<double> times_;
  std::vector<State> states_;
};

}  // namespace polhode
