// SPDX-License-Identifier: MIT
// Whether a motion can be trusted: what is known against it, before it is found and after.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/grid_trajectory.h"
#include "motion/motion_spec.h"

namespace polhode {

// What stands against an integrated motion, in words; nothing when `doubts` is empty.
struct Reliability {
  std::vector<std::string> doubts;
  std::optional<double> attitude_error_rad;  // against the closed form, where there is one
};

// Drift of energy or momentum, relative, beyond which a motion is not to be trusted.
inline constexpr double kTrustedDrift = 1e-3;

// Looks at what mechanics conserves, and at the closed form if the scene has one.
Reliability reliability_of(const BodyModel& model,
                           const State& start,
                           double duration,
                           double accuracy_rad,
                           const Integration& found);

// Before anything runs: the step that the scene asks for is beyond the method's known limit on this
// motion. In words; none if it is not.
std::optional<std::string> step_beyond_limit(const BodyModel& model,
                                             const State& start,
                                             const NumericsSpec& numerics);

// A film sampled every `frame_s` of motion shows a mark on the body turning backwards when the body
// turns by more than half a turn between frames. In words, with the time between frames that would
// mend it; none if it does not.
std::optional<std::string> turns_backwards(double fastest_rad_per_s, double frame_s);

}  // namespace polhode
