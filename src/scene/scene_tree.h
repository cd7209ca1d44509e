// SPDX-License-Identifier: MIT
// Scenes from TOML trees, with values that come from elsewhere than the scene file.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "base/error.h"
#include "scene/scene.h"
#include "scene/setting.h"

namespace polhode {

// A value that replaces one of a scene file, or is added to it.
struct Change {
  std::string path;  // of its key, as a scene file could spell it
  Place place;       // where it comes from; without a key, errors have that of the scene
  std::function<void(toml::table& tree)> apply;  // throws Error (input), as replace_value() does
};

// The change that a setting of the command line makes.
Change change_of(const Setting& setting);

// The same error at the place of the change that it is about; as it is if it is about none.
Error blamed(const Error& error, const std::vector<Change>& changes);

// Whether a path leads to a key or inside of it, in whatever units they are spelled.
bool is_within(const std::string& path, const std::string& around);

// Whether one of the two keys leads to the other or inside of it.
bool keys_overlap(const std::string& one, const std::string& other);
// Throws Error (input), without a place, if the two keys overlap; `swept` is that of a sweep.
void refuse_overlap(const std::string& swept, const std::string& key);

// The tree of a scene file. Throws Error (input) as read_file (base/system/atomic_file.h) and
// parse_toml do.
toml::table read_tree(const std::filesystem::path& file);

// Reads a scene from a tree; `name` is its file, for messages. Mesh files are not read. Throws
// Error (input) as Reader does.
Scene scene_of(const toml::table& tree, const std::string& name);

// Changes the tree, the one after the other, and reads a scene from it; Scene::options has the
// places of the changes. Mesh files are not read. Throws Error (input) as scene_of does; for what
// is wrong with a change, at its place.
Scene changed_scene_of(toml::table tree,
                       const std::string& name,
                       const std::vector<Change>& changes);
// The same with its mesh files. Also throws Error (input) as load_meshes (model/solids.h) does.
Scene changed_scene(toml::table tree,
                    const std::filesystem::path& file,
                    const std::vector<Change>& changes);

}  // namespace polhode
