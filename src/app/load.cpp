// SPDX-License-Identifier: MIT
#include "app/load.h"

#include <cmath>

namespace polhode {
namespace {

// runs a parser of option text; its error names the option
template <class Parse>
auto parse_option(const char* option, const Parse& parse) {
  try {
    return parse();
  } catch (const Error& error) {
    throw error.at({{}, 0, option});
  }
}

double positive(const char* option, double value) {
  if (std::isfinite(value) && value > 0.0) return value;
  throw input_error("must be a number greater than 0, got {}", value).at({{}, 0, option});
}

// the attitude error that the picture allows, rad
double accuracy_in_radians(const Scene& scene, const Model& model) {
  const Accuracy& accuracy = scene.numerics.accuracy;
  if (!accuracy.pixels) return accuracy.value;
  constexpr int kCoarse = 16;  // segments: enough to measure how far the body reaches
  const double radius =
      body_radius(body_look(scene.body, model, make_theme(scene.theme), kCoarse), model);
  return attitude_tolerance(scene.camera, accuracy.value, radius, frame_size(scene));
}

}  // namespace

Scene load_with_overrides(const std::filesystem::path& file, const Overrides& overrides) {
  Scene scene = load_scene(file);
  if (overrides.method) {
    parse_option("--method", [&] {
      if (*overrides.method == "auto" || *overrides.method == "exact") return 0;
      return find_stepper(*overrides.method).order;
    });
    // a step or tolerance of the scene belongs to the scene's own method
    if (*overrides.method != scene.numerics.method) {
      scene.numerics.step.reset();
      scene.numerics.tolerance.reset();
    }
    scene.numerics.method = *overrides.method;
  }
  if (overrides.step) scene.numerics.step = positive("--step", *overrides.step);
  if (overrides.tolerance) scene.numerics.tolerance = positive("--tolerance", *overrides.tolerance);
  if (overrides.accuracy) {
    scene.numerics.accuracy =
        parse_option("--accuracy", [&] { return parse_accuracy(*overrides.accuracy); });
  }
  if (overrides.size) {
    scene.video.size = parse_option("--size", [&] { return parse_picture_size(*overrides.size); });
  }
  if (overrides.fps) {
    scene.video.fps = parse_option("--fps", [&] { return parse_frame_rate(*overrides.fps); });
  }
  return scene;
}

void refuse_same_file(const std::string& written,
                      const std::string& what,
                      const std::filesystem::path& needed) {
  if (written.empty()) return;
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
    Model model = make_model(scene.body, scene.motion.hold == "pivot", gravity_of(scene.motion));
    const double accuracy = accuracy_in_radians(scene, model);
    auto found = [&] {
      const StageTimer timer(time);
      return simulate(model, scene.motion, scene.numerics, accuracy);
    }();
    return Solved{scene, model, std::move(found), time};
  });
}

}  // namespace polhode
