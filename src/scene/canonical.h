// SPDX-License-Identifier: MIT
// The canonical form of a scene as JSON. Reports embed it, and scene_hash() (scene/scene.h) is made
// from it.
#pragma once

#include "base/json.h"
#include "scene/scene.h"

namespace polhode {

// All values in SI, with defaults, in the order of the field lists and under the keys of the scene
// file. Absent optional values, empty lists and tables, Scene::file, lines and options are left
// out; meshes are given by the names of their files. scene_from_json() gives the same values back.
Json scene_to_json(const Scene& scene);

// The scene of such JSON, with its mesh files. `name` is the file name for messages; files that the
// scene names are relative to its folder. Throws Error (input) as load_scene does, but lines are
// not those of a file, and errors of mesh files have the key only.
Scene scene_from_json(const Json& json, const std::string& name);

}  // namespace polhode
