// SPDX-License-Identifier: MIT
#include "app/commands/section_job.h"

#include "base/error.h"
#include "chart/section.h"
#include "film/overrides.h"
#include "motion/motion.h"

namespace polhode {

std::pair<BodyModel, State> start_of_section(const Scene& scene) {
  refuse_numerics(scene, "for sections");
  const BodyModel model = make_model(scene.body, scene.motion);
  if (const std::optional<SectionObstacle> wrong = why_not_section(model))
    throw input_error("a section {}", wrong->needs).at({{}, 0, wrong->key});
  return {model, start_state(model, scene.motion)};
}

}  // namespace polhode
