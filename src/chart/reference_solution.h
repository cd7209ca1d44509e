// SPDX-License-Identifier: MIT
// The reference solution of a motion, with which numerical runs are compared, and its uncertainty.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/trajectory.h"

namespace polhode {

// The states at equally spaced times of a motion, from the closed form or, if there is none, from
// two accurate runs with methods of different kinds; on a table, from event to event at two
// tolerances. Immutable, so any thread may use it.
class ReferenceSolution {
 public:
  // Computes the states from t = 0 to `duration` (s, positive). Throws Error (interrupted) only: if
  // the runs fail, the uncertainty is infinite.
  ReferenceSolution(const BodyModel& model, const State& start, double duration);

  // Where it comes from, as text such as "closed form (asymmetric)" or "dop853 and kick_srkn11
  // agree". Without a usable reference the text begins with "nobody".
  const std::string& source() const { return source_; }
  // The possible error of the reference itself, rad: an estimate of round-off for a closed form,
  // else the largest deviation() (motion/deviation.h) between the two runs. Infinite, which means
  // that the reference is unusable, if a run failed or they differ by more than 0.05 rad.
  double uncertainty() const { return uncertainty_; }
  // Errors below this (rad) cannot be told from that of the reference itself: ten times its
  // uncertainty.
  double least_error() const { return 10.0 * uncertainty_; }
  // The 65 times (s), from 0 to the duration, and the states at these times (without meaning if the
  // uncertainty is infinite). Both are valid as long as this object.
  const std::vector<double>& times() const { return times_; }
  const std::vector<State>& states() const { return states_; }
  // The largest deviation() of a run from the reference at these times, rad; NaN if one is NaN. It
  // means nothing if the uncertainty is infinite. The run must cover the whole duration. Throws
  // Error (check_failed) as Trajectory::at does.
  double error_of(const Trajectory& run) const;
  // The deviation() of a state from the last state of the reference, rad; without meaning if the
  // uncertainty is infinite.
  double error_at_end(const State& end) const;

 private:
  void by_closed_form(const State& start);
  void by_two_methods(const State& start);
  void by_two_tolerances(const State& start);

  BodyModel model_;
  double duration_;
  std::string source_;
  double uncertainty_ = 0.0;
  std::vector<double> times_;
  std::vector<State> states_;
};

}  // namespace polhode
