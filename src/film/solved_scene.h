// SPDX-License-Identifier: MIT
// Computes the body model and the motion of a scene.
#pragma once

#include "base/system/progress.h"
#include "base/system/stage_clock.h"
#include "model/body_model.h"
#include "motion/simulate.h"
#include "scene/scene.h"

namespace polhode {

// A scene with its model and its motion.
struct Solved {
  Scene scene;            // a copy of what was solved
  BodyModel model;        // of scene.body, held as scene.motion says; with_translation is unset,
                          // see simulation.motion.model()
  Simulation simulation;  // the motion and how it was computed
  std::vector<Motion> ensemble;  // of motion.ensemble
  StageTime simulate_time;       // time spent on computing them
};

// Computes the motion, and logs doubts about it (Reliability in motion/reliability.h) as warnings.
// If the scene compares methods, its step and tolerance belong to them, and the motion is computed
// without them, to the accuracy of the scene. Likewise the motions of an ensemble, on all
// processors; of their doubts it tells one. Throws Error as make_model, accuracy_in_radians,
// start_state and simulate do; errors that name a key have the file and line of the scene.
// `progress`: how a long computation is shown.
Solved solve(const Scene& scene, ProgressKind progress = ProgressKind::none);
// The same without the ensemble, for what shows one motion.
Solved solve_alone(const Scene& scene, ProgressKind progress = ProgressKind::none);

// The attitude error that numerics.accuracy allows, rad. Pixels are converted by
// attitude_tolerance() (frame/compose.h), for the one of the scene's cameras (shots too) that
// asks for most, picture size, size of the body and points. Throws Error (input) as body_look
// (frame/body_look.h), make_theme (frame/theme.h) and attitude_tolerance do.
double accuracy_in_radians(const Scene& scene, const BodyModel& model);

}  // namespace polhode
