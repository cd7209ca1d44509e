// SPDX-License-Identifier: MIT
// A small scene of a deck, in a folder of its own.
#pragma once

#include <memory>
#include <string>

#include "lecture/products.h"
#include "scene/scene_file.h"
#include "support/run.h"

namespace polhode::test {

class DeckSceneFolder {
 public:
  explicit DeckSceneFolder(const std::string& more = "", const std::string& name = "top.toml") {
    write_text(folder_ / name, kSmallScene + more);
    scene.name = name;
    scene.file = folder_ / name;
    scene.scene = load_scene(scene.file);
    scene.hash = scene_hash(scene.scene);
  }
  std::string operator/(const std::string& name) const { return folder_ / name; }
  const std::filesystem::path& path() const { return folder_.path(); }

  DeckScene scene;

 private:
  TemporaryFolder folder_;
};

}  // namespace polhode::test
