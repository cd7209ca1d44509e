// SPDX-License-Identifier: MIT
// From a model and a start to a motion: picks the least that answers, and says why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/grid_trajectory.h"
#include "motion/motion.h"
#include "motion/reliability.h"
#include "motion/solution_method.h"

namespace polhode {

// How a motion was found, for the report.
struct SimulationReport {
  std::string model;
  std::string model_reason;
  std::string method;  // "exact" for a closed form
  std::string method_reason;
  std::optional<double> step;  // s
  std::optional<double> tolerance;
  double accuracy_rad = 0.0;                 // what was asked for
  std::optional<double> error_estimate_rad;  // attitude, against a finer run; absent: not estimated
  IntegrationRecord record;
  Reliability reliability;  // nothing stands against a closed form
};

struct Simulation {
  Motion motion;
  SimulationReport report;
};

// accuracy_rad: attitude error allowed over the whole motion, used when the scene fixes neither
// step nor tolerance: the method is then refined until two runs agree within it. Throws Error
// (input): a model that cannot take the scene, a method that cannot reach the accuracy; (check
// failed) when the motion turns to NaN or a step has no solution.
Simulation simulate(const BodyModel& model,
                    const MotionSpec& motion,
                    const NumericsSpec& numerics,
                    double accuracy_rad);

}  // namespace polhode
