// SPDX-License-Identifier: MIT
// Computes the motion of a model: chooses the solution method and the integrator, and reports why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/conditioning.h"
#include "motion/grid_trajectory.h"
#include "motion/motion.h"
#include "motion/refinement.h"
#include "motion/reliability.h"
#include "motion/solution_method.h"

namespace polhode {

// How a motion was computed, for the report.
struct SimulationReport {
  std::string model;                         // name of the solution method
  std::string model_reason;                  // one phrase
  std::string method;                        // name of the integrator; "exact" for a closed form
  std::string method_reason;                 // one phrase
  std::optional<double> step;                // s; absent for a closed form and adaptive methods
  std::optional<double> tolerance;           // local error per step; for adaptive methods
  double accuracy_rad = 0.0;                 // as requested
  std::optional<double> error_estimate_rad;  // of the attitude; absent: not estimated
  // absent for integrations with a given step or tolerance
  std::optional<Conditioning> conditioning;
  IntegrationRecord record;
  Reliability reliability;
};

// The most steps of one run: while it is refined to an accuracy, and with a given step or
// tolerance. numerics.max_steps replaces both. A million steps take about a second.
inline constexpr long kMostStepsRefined = 1'000'000;
inline constexpr long kMostStepsGiven = 5'000'000;

// A motion with its report.
struct Simulation {
  Motion motion;
  SimulationReport report;
};

// accuracy_rad: allowed attitude error over the whole motion. If the scene gives neither step nor
// tolerance, the method is refined until its runs converge within it (motion/refinement.h). Throws
// Error (input) as start_state does, and naming numerics.model or numerics.method if they cannot
// handle the scene, numerics.step or numerics.tolerance if they do not suit the method, and
// numerics.accuracy if it cannot be reached; (check_failed) if the motion becomes NaN or the
// equations of an implicit step have no solution; (interrupted) if the program is interrupted;
// and what `watch` throws, which is not told of closed forms. `neighbour` tells of a motion of this
// duration that begins nearby: where this one is refined with the same method, it begins two runs
// before what did there.
Simulation simulate(const BodyModel& model,
                    const MotionSpec& motion,
                    const NumericsSpec& numerics,
                    double accuracy_rad,
                    const SimulationWatch& watch = {},
                    const SimulationReport* neighbour = nullptr);

}  // namespace polhode
