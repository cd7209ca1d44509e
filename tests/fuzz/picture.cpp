// SPDX-License-Identifier: MIT
// Scenes, from the plan of the film to what its cameras see at both ends, for motions that have a
// closed form. Cameras are set up by hundreds of samples, so this is far slower than scene.cpp.
#include "base/error.h"
#include "film/frame_times.h"
#include "film/solved_scene.h"
#include "frame/compose.h"
#include "fuzz/harness.h"
#include "fuzz/scene_text.h"
#include "motion/solution_method.h"

namespace polhode {

namespace {

void look_at(const Scene& scene) {
  check_time_range(scene, {});
  std::string reason;
  const BodyModel model = make_model(scene.body, scene.motion);
  if (!choose_solution_method(model, scene.numerics, accuracy_in_radians(scene, model), reason)
           .closed_form)
    return;
  const Solved solved = solve(scene);
  const FrameTimes frames = plan_frame_times(solved, {});
  const Composer composer(
      solved.simulation.motion,
      scene.body,
      {.camera = scene.camera, .shots = scene.shots, .timeline = frames.timeline},
      scene.show,
      scene.theme,
      scene.video.size);
  composer.warnings();
  for (const double t : {0.0, frames.timeline.film_duration()})
    composer.camera_view(t, scene.motion.duration);
}

}  // namespace

void run_harness(const std::string& bytes) {
  for (const Scene& scene : scenes_of_text(bytes))
    look_at(scene);
}

}  // namespace polhode
