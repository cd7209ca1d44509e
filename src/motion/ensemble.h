// SPDX-License-Identifier: MIT
// Starts near the start of a motion.
#pragma once

#include <vector>

#include "model/body_model.h"
#include "motion/motion_spec.h"

namespace polhode {

// The motions of spec.ensemble: like `spec`, but each turned by a rotation vector from a ball of
// radius EnsembleSpec::tilt, and with an angular momentum that differs by a vector from a ball of
// the radius EnsembleSpec::momentum times its length. The points fill the balls evenly and are the
// same on every machine. `model` is that of `spec`. Empty without an ensemble. Throws Error (input)
// as start_state does, and with motion.ensemble as key for an ensemble whose starts are all the
// same.
std::vector<MotionSpec> ensemble_of(const BodyModel& model, const MotionSpec& spec);

}  // namespace polhode
