// SPDX-License-Identifier: MIT
// Decides whether a motion can be trusted, before and after it is computed. Each doubt is a
// sentence for the user.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/grid_trajectory.h"
#include "motion/motion_spec.h"

namespace polhode {

// The doubts about an integrated motion; it is trusted if there are none.
struct Reliability {
  std::vector<std::string> doubts;
  // The largest deviation() (motion/deviation.h) from the closed form at 258 times, rad; absent if
  // there is no closed form or the model has six degrees of freedom.
  std::optional<double> attitude_error_rad;
};

// Relative drift of energy or angular momentum beyond which a motion is not trusted.
inline constexpr double kTrustedDrift = 1e-3;

// A doubt for each conserved quantity that drifts by more than that; also of closed forms, whose
// numbers may overflow or vanish.
std::vector<std::string> doubts_of_drift(const BodyModel& model, const Drift& drift);

// Checks the motion `found` from 0 to `duration` (s): the drift of the conserved quantities, and,
// if there is a closed form, the error against it, which may be at most accuracy_rad.
// Throws Error (check_failed) as Trajectory::at (motion/trajectory.h) does.
Reliability reliability_of(const BodyModel& model,
                           const State& start,
                           double duration,
                           double accuracy_rad,
                           const Integration& found);

// Before integrating: a doubt if numerics.step exceeds the method's known step limit
// (motion/step_limit.h) on this motion. None without numerics.step, or if numerics.method is
// "auto".
std::optional<std::string> step_beyond_limit(const BodyModel& model,
                                             const State& start,
                                             const NumericsSpec& numerics);

// A doubt if a body with the greatest angular speed fastest_rad_per_s turns by more than half a
// turn between frames that are `frame_s` (s of motion) apart, so that it seems to turn backwards.
std::optional<std::string> turns_backwards(double fastest_rad_per_s, double frame_s);

}  // namespace polhode
