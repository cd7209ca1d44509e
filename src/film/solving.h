// SPDX-License-Identifier: MIT
// Computes the body model and the motion of a scene for whoever watches it: a command
// (film/solved_scene.h) or a page (export/recomputed.h).
#pragma once

#include <functional>
#include <vector>

#include "base/error.h"
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

// Who is told what. Empty functions are not called.
struct SolveWatch {
  std::function<void(const Error&)> warn;  // of doubts about the motion, with their place
  SimulationWatch progress;
};

// Does what solve() (film/solved_scene.h) promises, but writes nothing anywhere.
Solved solve_watched(const Scene& scene, const SolveWatch& watch);

// The attitude error that numerics.accuracy allows, rad. Pixels are converted by
// attitude_tolerance() (frame/attitude_tolerance.h), for the one of the scene's cameras (shots too)
// that asks for most, picture size, size of the body and points. `places`: where the reference
// point is seen, S, m; empty: where it starts. Throws Error (input) as start_state
// (motion/motion.h), body_look (frame/body_look.h), make_theme (frame/theme.h) and
// attitude_tolerance do.
double accuracy_in_radians(const Scene& scene,
                           const BodyModel& model,
                           const std::vector<Vec3>& places = {});

}  // namespace polhode
