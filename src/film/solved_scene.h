// SPDX-License-Identifier: MIT
// Computes the body model and the motion of a scene.
#pragma once

#include "base/system/stage_clock.h"
#include "model/body_model.h"
#include "motion/simulate.h"
#include "scene/scene.h"

namespace polhode {

// A scene with its model and its motion.
struct Solved {
  Scene scene;
  BodyModel model;
  Simulation simulation;
  StageTime simulate_time;
};

// Computes the motion, and logs doubts about it as warnings. Throws Error as make_model,
// start_state and simulate do, with file and line of the scene.
Solved solve(const Scene& scene);

// The attitude error that numerics.accuracy allows, rad. Pixels are converted by
// attitude_tolerance().
double accuracy_in_radians(const Scene& scene, const BodyModel& model);

}  // namespace polhode
