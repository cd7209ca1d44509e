// SPDX-License-Identifier: MIT
// Scenes with a closed form, and the films that are planned of them without a file.
#pragma once

#include <string>

#include "film/prepared_film.h"
#include "scene/scene_file.h"
#include "support/run.h"

namespace polhode::test {

// A free symmetric top for one second, ten frames of 64 by 48 pixels; `more` stands behind the
// [video] table.
inline Scene small_scene(const std::string& more = "") {
  Scene scene = parse_scene(std::string(kSmallScene) + more, "scene.toml");
  scene.video.size = {64, 48};
  return scene;
}

// The plan of the whole film, nothing of it encoded.
inline RenderPlan plan_of(const Scene& scene, const std::string& output = "null") {
  RenderPlan plan;
  plan.scene = scene;
  plan.story = scene.story;
  plan.sink = sink_of(scene, output, {}, false, false);
  plan.text = false;
  return plan;
}

// The message of the Error that `work` throws; "" when it throws none.
template <class Work>
std::string message_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace polhode::test
