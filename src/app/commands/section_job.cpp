// SPDX-License-Identifier: MIT
#include "app/commands/section_job.h"

#include "base/error.h"
#include "chart/section.h"
#include "film/overrides.h"
#include "motion/motion.h"
#include "scene/scene_file.h"

namespace polhode {

std::pair<BodyModel, State> start_of_section(const Scene& scene) {
  refuse_numerics(scene, "for sections");
  refuse_given(scene, "motion.duration", "is not for sections, which end after --crossings");
  refuse_given(scene, "motion.ensemble", "is not for sections, which have starts of their own");
  const BodyModel model = make_model(scene.body, scene.motion);
  if (const std::optional<SectionObstacle> wrong = why_not_section(model))
    throw input_error("a section {}", wrong->needs).at({{}, 0, wrong->key});
  return {model, start_state(model, scene.motion)};
}

}  // namespace polhode
