// SPDX-License-Identifier: MIT
#include "app/commands/section_job.h"

#include <algorithm>

#include "base/error.h"
#include "chart/section.h"
#include "motion/motion.h"

namespace polhode {

std::pair<BodyModel, State> start_of_section(const Scene& scene) {
  // those of a file are for the film of its motion
  const auto given = std::find_if(scene.options.begin(), scene.options.end(), [](const auto& one) {
    return one.first.starts_with("numerics.");
  });
  if (given != scene.options.end()) {
    throw input_error("is not for sections, which have a method and an accuracy of their own")
        .at({{}, 0, given->first});
  }
  const BodyModel model = make_model(scene.body, scene.motion);
  if (const std::optional<SectionObstacle> wrong = why_not_section(model))
    throw input_error("a section {}", wrong->needs).at({{}, 0, wrong->key});
  return {model, start_state(model, scene.motion)};
}

}  // namespace polhode
