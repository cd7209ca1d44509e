// SPDX-License-Identifier: MIT
// Computes the motion of a scene for a command: doubts are logged, progress is shown.
#pragma once

#include "base/system/progress.h"
#include "film/solving.h"

namespace polhode {

// Computes the motion, and logs doubts about it (Reliability in motion/reliability.h) as warnings.
// If the scene compares methods, its step and tolerance belong to them, and the motion is computed
// without them, to the accuracy of the scene. Likewise the motions of an ensemble, on all
// processors; of their doubts it tells one. Throws Error as make_model, accuracy_in_radians,
// start_state and simulate do; errors that name a key have the file and line of the scene.
// `progress`: how a long computation is shown.
Solved solve(const Scene& scene, ProgressKind progress = ProgressKind::none);
// The same without the ensemble, for what shows one motion.
Solved solve_alone(const Scene& scene, ProgressKind progress = ProgressKind::none);

}  // namespace polhode
