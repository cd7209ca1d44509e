// SPDX-License-Identifier: MIT
// Scene and film files from bytes, as if they stood among the shipped scenes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/solids.h"
#include "scene/film_file.h"
#include "scene/scene_file.h"
#include "scene/toml_text.h"

namespace polhode {

inline const std::filesystem::path kScenes = POLHODE_SOURCE_DIR "/scenes";

// The scene of the bytes or, of a film, those of its first two panels: more cost more time, and say
// no more.
inline std::vector<Scene> scenes_of_text(const std::string& bytes) {
  const toml::table tree = parse_toml(bytes, "a.toml");
  std::vector<Scene> scenes;
  if (is_film(tree)) {
    for (const ScenePanel& panel : load_film(tree, kScenes / "a.toml", {}).panels) {
      if (scenes.size() < 2) scenes.push_back(panel.scene);
    }
    return scenes;
  }
  scenes.push_back(parse_scene(bytes, "a.toml"));
  load_meshes(scenes.back().body, kScenes);
  return scenes;
}

}  // namespace polhode
