// SPDX-License-Identifier: MIT
// A scene with everything resolved, as JSON: what reports embed and what the scene's hash is made
// of.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"

namespace polhode {

// Every value in SI, in the order of the field lists, defaults included; absent options and the
// file's name left out. Read as a scene again, it gives the same scene.
nlohmann::ordered_json scene_to_json(const Scene& scene);

// The scene of such a JSON; `name` stands for the file in messages, and files that the scene names
// stand beside it. Throws Error (input) as load_scene does.
Scene scene_from_json(const nlohmann::ordered_json& json, const std::string& name);

}  // namespace polhode
