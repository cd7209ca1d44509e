// SPDX-License-Identifier: MIT
#include "film/overrides.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/at_place.h"
#include "frame/theme.h"
#include "motion/simulate.h"
#include "motion/stepper_table.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

double positive(double value) {
  if (std::isfinite(value) && value > 0.0) return value;
  throw input_error("must be a number greater than 0, got {}", value);
}

void apply(const Overrides& overrides, Scene& scene) {
  // runs `set`, and remembers where the value of the key comes from; its errors name the option
  const auto replace = [&](const char* key, const char* option, const auto& set) {
    at_place({{}, 0, option}, [&] {
      refuse_given_for_panels(scene, key);
      set();
    });
    scene.options[key] = {{}, 0, option};
  };
  NumericsSpec& numerics = scene.numerics;
  if (overrides.method) {
    replace("numerics.method", "--method", [&] {
      if (*overrides.method != "auto" && *overrides.method != "exact") {
        find_stepper(*overrides.method);
      }
      // a step or tolerance of the scene belongs to the scene's own method; one of the command line
      // does not
      const auto is_set = [&](const char* key) {
        const auto place = scene.options.find(key);
        return place != scene.options.end() && place->second.file.empty();
      };
      if (*overrides.method != numerics.method) {
        const auto leave_out = [&](const char* name, std::optional<double>& value) {
          if (is_set(name)) return;
          if (value) refuse_given_for_panels(scene, name);
          value.reset();
        };
        leave_out("numerics.step", numerics.step);
        leave_out("numerics.tolerance", numerics.tolerance);
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
  if (overrides.theme) {
    replace("video.theme", "--theme", [&] {
      find_theme(*overrides.theme);
      scene.theme = {.theme = *overrides.theme, .background = {}};
    });
  }
  if (overrides.loop) scene.video.loop = true;
}

}  // namespace

void check_overrides(const Overrides& overrides) {
  Scene scene;
  apply(overrides, scene);
}

Scene load_with_overrides(const std::filesystem::path& file, const Overrides& overrides) {
  Scene scene = load_scene(file, overrides.settings);
  for_each_scene(scene, [&](Scene& one) { apply(overrides, one); });
  return scene;
}

Scene parse_with_overrides(std::string_view text,
                           const std::string& name,
                           const Overrides& overrides) {
  Scene scene = parse_scene(text, name, overrides.settings);
  apply(overrides, scene);
  return scene;
}

void refuse_numerics(const Scene& scene,
                     const std::string& whom,
                     const std::vector<std::string>& used) {
  for (const auto& [key, place] : scene.options) {
    if (!key.starts_with("numerics.") || std::find(used.begin(), used.end(), key) != used.end())
      continue;
    throw input_error("is not {}, which choose methods, steps and accuracies themselves", whom)
        .at({{}, 0, key});
  }
}

Scene load_single(const std::filesystem::path& file, const Overrides& overrides) {
  Scene scene = load_with_overrides(file, overrides);
  refuse_panels(scene);
  NumericsSpec& numerics = scene.numerics;
  if (!numerics.compare.empty() && (overrides.step || overrides.tolerance)) {
    // it is meant for the one motion; those of the scene are for the methods that it compares
    numerics.compare.clear();
    if (!overrides.step) numerics.step.reset();
    if (!overrides.tolerance) numerics.tolerance.reset();
  }
  return scene;
}

}  // namespace polhode
