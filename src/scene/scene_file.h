// SPDX-License-Identifier: MIT
// Reads scene files and film files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "scene/setting.h"

namespace polhode {

// Reads a scene, or the scenes of a film file, and their mesh files. Throws Error (input) as
// read_file (base/system/atomic_file.h) and parse_toml (scene/toml_text.h) do, and with file, line
// and key as Reader (scene/reader.h) and load_meshes (model/solids.h) do; and as load_film
// (scene/film_file.h) does. Whether the values together make sense is checked later, by make_model
// and start_state. Keys are dotted paths; lists count from 0: "body.parts[1].mass".
Scene load_scene(const std::filesystem::path& file);

// Numbers that replace those in the file, by paths of keys as in Setting.
using Replacements = std::vector<std::pair<std::string, double>>;

// Reads a scene with these settings and then these numbers, as if they stood in the file; keys that
// it lacks are added. Scene::options names the settings. Also throws Error (input): with
// option_of() the setting as key for a value that the key cannot have, a key that is none, and an
// entry of a list that does not exist; without a place for a path of a number that is no key or
// leads to something else; with the file for numbers in a film file.
Scene load_scene(const std::filesystem::path& file,
                 const std::vector<Setting>& settings,
                 const Replacements& numbers = {});

// The number at such a path, in the unit of its spelling; absent if there is none. Throws Error
// (input) as read_file and parse_toml do, as load_scene does for settings, and, without a place,
// for a path that is not a key.
std::optional<double> number_in_scene(const std::filesystem::path& file,
                                      const std::vector<Setting>& settings,
                                      const std::string& path);

// A scene from a text in memory; `name` is the file name for messages. Mesh files are not read.
// Throws Error (input) as parse_toml and Reader do.
Scene parse_scene(std::string_view text, const std::string& name);
// The same with these settings, as load_scene() has them. Also throws Error (input) as that does
// for settings.
Scene parse_scene(std::string_view text,
                  const std::string& name,
                  const std::vector<Setting>& settings);

// The files that a scene names, its meshes, without opening them; of a film file also its scenes,
// which are read. As spelled there, relative to the folder of the file. Throws Error (input) as
// load_scene does for these files.
std::vector<std::string> named_files(const std::filesystem::path& file);

// Throws Error (input), with the key, if an option has set `key` or something in it. why: "is ...".
void refuse_given(const Scene& scene, const std::string& key, const std::string& why);

// Throws Error (input), without a place, if the sweep of a film file changes this key of the scene,
// a key in it or one around it, for the heading of a panel tells the value of the sweep; likewise
// if a setting gives it for one panel.
void refuse_given_for_panels(const Scene& scene, const std::string& key);

}  // namespace polhode
