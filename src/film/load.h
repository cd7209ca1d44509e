// SPDX-License-Identifier: MIT
// The first steps that every command shares: scene file, options that override it, model, motion.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/system/stage_clock.h"
#include "frame/compose.h"
#include "model/body_model.h"
#include "motion/simulate.h"
#include "scene/scene.h"

namespace polhode {

// What the command line may say instead of the scene; absent: the scene's word holds.
struct Overrides {
  std::optional<std::string> method;
  std::optional<double> step;  // s
  std::optional<double> tolerance;
  std::optional<std::string> accuracy;  // "0.1px" or radians
  std::optional<std::string> size;      // "1920x1080"
  std::optional<std::string> fps;       // "60" or "30000/1001"
  bool loop = false;                    // ends the film where the motion is back at its start
};

// A scene, checked, with its model and its motion.
struct Solved {
  Scene scene;
  BodyModel model;
  Simulation simulation;
  StageTime simulate_time;
};

// The methods of a list such as "rk4,dop853", all of them for "". Throws Error (input), naming
// --methods.
std::vector<const StepperInfo*> parse_methods(const std::string& names);

// Scene with the overrides applied. Throws Error (input) with file, line and key, or the option.
Scene load_with_overrides(const std::filesystem::path& file, const Overrides& overrides);

// Throws Error (input) when a file that will be written is one that is needed: nobody's scene is
// overwritten by a slip of the keyboard.
// Also when it has a scene file's ending.
void refuse_same_file(const std::string& written,
                      const std::string& what,
                      const std::filesystem::path& needed);

// Finds the motion. Errors name the place in the scene file.
Solved solve(const Scene& scene);

// The attitude error that the scene allows, rad: given, or what moves nothing in the picture by
// more than its pixels.
double accuracy_in_radians(const Scene& scene, const BodyModel& model);

// The error with the place of its key: file and line, or the option that the value came from.
Error placed(const Scene& scene, const Error& error);

// Runs `work`; an Error without a file gets its place in the scene.
template <class Work>
auto with_place(const Scene& scene, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw placed(scene, error);
  }
}

inline FrameSize frame_size(const Scene& scene) {
  return {scene.video.size.width, scene.video.size.height};
}

}  // namespace polhode
