// SPDX-License-Identifier: MIT
#include "film/load.h"

#include <cmath>

#include <spdlog/spdlog.h>

#include "base/at_place.h"
#include "base/name_list.h"

namespace polhode {
namespace {

double positive(double value) {
  if (std::isfinite(value) && value > 0.0) return value;
  throw input_error("must be a number greater than 0, got {}", value);
}

}  // namespace

Scene load_with_overrides(const std::filesystem::path& file, const Overrides& overrides) {
  Scene scene = load_scene(file);
  // runs `set`, and remembers where the value of the key comes from; its errors name the option
  const auto replace = [&](const char* key, const char* option, const auto& set) {
    at_place({{}, 0, option}, set);
    scene.options[key] = option;
  };
  NumericsSpec& numerics = scene.numerics;
  if (overrides.method) {
    replace("numerics.method", "--method", [&] {
      if (*overrides.method != "auto" && *overrides.method != "exact") {
        find_stepper(*overrides.method);
      }
      // a step or tolerance of the scene belongs to the scene's own method
      if (*overrides.method != numerics.method) {
        numerics.step.reset();
        numerics.tolerance.reset();
      }
      numerics.method = *overrides.method;
      numerics.compare.clear();
    });
  }
  if (overrides.step) {
    replace("numerics.step", "--step", [&] { numerics.step = positive(*overrides.step); });
  }
  if (overrides.tolerance) {
    replace("numerics.tolerance", "--tolerance", [&] {
      numerics.tolerance = positive(*overrides.tolerance);
    });
  }
  if (overrides.accuracy) {
    replace("numerics.accuracy", "--accuracy", [&] {
      numerics.accuracy = parse_accuracy(*overrides.accuracy);
    });
  }
  if (overrides.size) {
    replace(
        "video.size", "--size", [&] { scene.video.size = parse_picture_size(*overrides.size); });
  }
  if (overrides.fps) {
    replace("video.fps", "--fps", [&] { scene.video.fps = parse_frame_rate(*overrides.fps); });
  }
  if (overrides.loop) scene.video.loop = true;
  return scene;
}

double accuracy_in_radians(const Scene& scene, const BodyModel& model) {
  const Accuracy& accuracy = scene.numerics.accuracy;
  if (!accuracy.pixels) return accuracy.value;
  constexpr int kCoarse = 16;  // segments: enough to measure how far the body reaches
  const double radius =
      body_radius(body_look(scene.body, model, make_theme(scene.theme), kCoarse), model);
  return attitude_tolerance(scene.camera, accuracy.value, radius, frame_size(scene));
}

Error placed(const Scene& scene, const Error& error) {
  const Place& place = error.place();
  if (place.key.empty() || !place.file.empty()) return error;
  const auto option = scene.options.find(place.key);
  if (option == scene.options.end()) {
    return error.at({scene.file, line_of(scene, place.key), {}});
  }
  return {error.fault(), error.message(), {{}, 0, option->second}};
}

void refuse_same_file(const std::string& written,
                      const std::string& what,
                      const std::filesystem::path& needed) {
  if (written.empty()) return;
  if (written.ends_with(".toml")) {
    throw input_error("{} '{}' has the ending of scene files; choose another name", what, written);
  }
  std::error_code ignored;
  if (std::filesystem::path(written).lexically_normal() != needed.lexically_normal() &&
      !std::filesystem::equivalent(written, needed, ignored)) {
    return;
  }
  throw input_error("{} would overwrite {}; choose another name", what, needed.string());
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

std::vector<const StepperInfo*> parse_methods(const std::string& names) {
  std::vector<const StepperInfo*> methods;
  for (const std::string& name : split_names(names))
    at_place({{}, 0, "--methods"}, [&] { methods.push_back(&find_stepper(name)); });
  if (methods.empty()) {
    for (const StepperInfo& row : stepper_table())
      methods.push_back(&row);
  }
  return methods;
}

}  // namespace polhode
