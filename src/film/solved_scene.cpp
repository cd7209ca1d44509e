// SPDX-License-Identifier: MIT
#include "film/solved_scene.h"

#include <spdlog/spdlog.h>

#include "film/error_places.h"
#include "frame/compose.h"

namespace polhode {

double accuracy_in_radians(const Scene& scene, const BodyModel& model) {
  const Accuracy& accuracy = scene.numerics.accuracy;
  if (!accuracy.pixels) return accuracy.value;
  constexpr int kCoarse = 16;  // segments: enough to measure how far the body reaches
  const double radius =
      body_radius(body_look(scene.body, model, make_theme(scene.theme), kCoarse), model);
  return attitude_tolerance(scene.camera, accuracy.value, radius, scene.video.size);
}

Solved solve(const Scene& scene) {
  return with_place(scene, [&] {
    StageTime time;
    BodyModel model = make_model(scene.body, scene.motion);
    const double accuracy = accuracy_in_radians(scene, model);
    const auto warn = [&](const std::string& words, const char* key) {
      spdlog::warn("{}", placed(scene, input_error("{}", words).at({{}, 0, key})).what());
    };
    // where methods are compared, steps and tolerances are theirs, and this is the truth
    NumericsSpec numerics = scene.numerics;
    if (!numerics.compare.empty()) {
      numerics.step.reset();
      numerics.tolerance.reset();
    }
    const std::optional<std::string> too_long =
        step_beyond_limit(model, start_state(model, scene.motion), numerics);
    if (too_long) warn(*too_long, "numerics.step");
    auto found = [&] {
      const StageTimer timer(time);
      return simulate(model, scene.motion, numerics, accuracy);
    }();
    for (const std::string& doubt : found.report.reliability.doubts)
      warn("the motion cannot be trusted: " + doubt, "numerics.method");
    return Solved{scene, model, std::move(found), time};
  });
}

}  // namespace polhode
