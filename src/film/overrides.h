// SPDX-License-Identifier: MIT
// Values of a scene that options of the command line can override.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "scene/setting.h"

namespace polhode {

// The values; those that are absent are taken from the scene.
struct Overrides {
  std::vector<Setting> settings;  // come first; the other values replace them
  // Name of a stepper (motion/stepper_table.h), "exact" or "auto".
  std::optional<std::string> method;
  std::optional<double> step;           // s, positive
  std::optional<double> tolerance;      // relative local error per step, positive; for adaptive
                                        // methods
  std::optional<std::string> accuracy;  // of the attitude: pixels as "0.1px", radians as "1e-6"
  std::optional<std::string> size;      // of the picture, pixels, as "1920x1080"
  std::optional<std::string> fps;       // frames per second, as "60" or "30000/1001"
  std::optional<std::string> theme;     // one of theme_names() (frame/view_spec.h); the background
                                        // is that of the theme then
  bool loop = false;                    // true: end the film where the motion is back at its start
};

// Throws Error (input), with the option as key, for values that no scene can take.
void check_overrides(const Overrides& overrides);

// Loads a scene and applies the overrides. A method also removes numerics.compare and, if it is not
// the scene's own, the scene's step and tolerance (not those of `settings`), which
// warn_of_unused_in_motion() (film/unused_settings.h) tells. Scene::options records which options
// have replaced a key (not --loop). Throws Error (input) as load_scene does, and with the option
// (--method, --step, --tolerance, --accuracy, --size, --fps, --theme) as key for an invalid value.
Scene load_with_overrides(const std::filesystem::path& file, const Overrides& overrides);
// The same for the text of a scene; `name` is the name of its file for messages. Mesh files are not
// read. Throws Error (input) as parse_scene (scene/scene_file.h) does, and likewise.
Scene parse_with_overrides(std::string_view text,
                           const std::string& name,
                           const Overrides& overrides);
// Throws Error (input), with the key, if an option has set a key of [numerics] that a command has
// no use for: all but `used`. Those of a file are for its film. whom: "for sections".
void refuse_numerics(const Scene& scene,
                     const std::string& whom,
                     const std::vector<std::string>& used = {});
// The same as load_with_overrides() for what works on one motion: a step or a tolerance also
// removes numerics.compare and the other one of the two. Also throws Error (input), with the file,
// for a film file.
Scene load_single(const std::filesystem::path& file, const Overrides& overrides);

}  // namespace polhode
