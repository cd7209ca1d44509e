// SPDX-License-Identifier: MIT
// Starts near the start of a motion.
#pragma once

#include <vector>

#include "model/body_model.h"
#include "motion/motion_spec.h"
#include "motion/simulate.h"

namespace polhode {

// Throws Error (input), with motion.ensemble as key, for an ensemble whose starts are all the same.
void check_ensemble(const MotionSpec& spec);

// The motions of spec.ensemble: like `spec`, but each turned by a rotation vector from a ball of
// radius EnsembleSpec::tilt, and with an angular momentum that differs by a vector from a ball of
// the radius EnsembleSpec::momentum times its length. The points fill the balls evenly and are the
// same on every machine. `model` is that of `spec`. Empty without an ensemble. Throws Error (input)
// as start_state and check_ensemble do.
std::vector<MotionSpec> ensemble_of(const BodyModel& model, const MotionSpec& spec);

// The motions of `members`, which begin near each other, on all processors (motion/convoy.h) or as
// many threads as `jobs` says. The first kLanes are computed as any motion; what the first of them
// needed tells where the refinement of the others begins, so that few of their runs are in vain.
// Other arguments and errors are those of simulate().
std::vector<Simulation> simulate_ensemble(const BodyModel& model,
                                          const std::vector<MotionSpec>& members,
                                          const NumericsSpec& numerics,
                                          double accuracy_rad,
                                          int jobs = 0);

}  // namespace polhode
