// SPDX-License-Identifier: MIT
// From a scene to its body and its motion.
#pragma once

#include "base/system/stage_clock.h"
#include "model/body_model.h"
#include "motion/simulate.h"
#include "scene/scene.h"

namespace polhode {

// A scene, checked, with its model and its motion.
struct Solved {
  Scene scene;
  BodyModel model;
  Simulation simulation;
  StageTime simulate_time;
};

// Finds the motion, and logs what makes it doubtful. Errors name the place in the scene file.
Solved solve(const Scene& scene);

// The attitude error that the scene allows, rad: given, or what moves nothing in the picture by
// more than its pixels.
double accuracy_in_radians(const Scene& scene, const BodyModel& model);

}  // namespace polhode
