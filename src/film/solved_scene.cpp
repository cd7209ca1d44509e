// SPDX-License-Identifier: MIT
#include "film/solved_scene.h"

#include <optional>

#include <spdlog/spdlog.h>

#include "film/error_places.h"
#include "film/unused_settings.h"
#include "motion/ensemble.h"

namespace polhode {

Solved solve_alone(const Scene& scene, ProgressKind progress) {
  with_place(scene, [&] { check_ensemble(scene.motion); });
  warn_of_unused_in_motion(scene);
  Scene alone = scene;
  alone.motion.ensemble.reset();
  Solved solved = solve(alone, progress);
  solved.scene = scene;
  return solved;
}

Solved solve(const Scene& scene, ProgressKind progress) {
  std::optional<Waiting> waiting;
  return solve_watched(
      scene,
      {[&](const Error& doubt) {
         waiting.reset();  // its line makes room
         spdlog::warn("{}", doubt.what());
       },
       [&](int run, double part) {
         if (!waiting) waiting.emplace(progress);
         waiting->show(fmt::format("computing the motion: run {}, {:.0f} %", run, 100.0 * part));
       }});
}

}  // namespace polhode
