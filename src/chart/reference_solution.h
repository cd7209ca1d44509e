// SPDX-License-Identifier: MIT
// The reference solution that runs are compared with.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/trajectory.h"

namespace polhode {

// Knows the motion at times spread over it: from the closed form, or where there is none from two
// runs with methods of different kinds.
class ReferenceSolution {
 public:
  ReferenceSolution(const BodyModel& model, const State& start, double duration);

  // How it knows, for people: "closed form (asymmetric)", "dop853 and kick_srkn11 agree".
  const std::string& source() const { return source_; }
  // How far the reference itself may be off, rad; infinite when nobody knows it.
  double uncertainty() const { return uncertainty_; }
  // Errors smaller than this cannot be told from those of the reference: ten times its uncertainty.
  double least_error() const { return 10.0 * uncertainty_; }
  // The times over the motion, first and last included, and the states there.
  const std::vector<double>& times() const { return times_; }
  const std::vector<State>& states() const { return states_; }
  // The largest deviation (motion/scales.h) at the times of the reference; NaN if one is.
  double error_of(const Trajectory& run) const;
  // The deviation of this state from the end of the motion.
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
