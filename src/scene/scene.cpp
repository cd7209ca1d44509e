// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include "base/atomic_file.h"
#include "base/hash.h"
#include "scene/reader.h"
#include "scene/text.h"

namespace polhode {

Scene parse_scene(std::string_view text, const std::string& name) {
  const toml::table tree = parse_toml(text, name);
  Scene scene;
  scene.file = name;
  Reader reader(tree, {name, 0, {}}, keys_of<Scene>());
  reader.read_tables({tree, {name, 0, {}}, suffixes_of(Unit::none).front()}, scene);
  return scene;
}

Scene load_scene(const std::filesystem::path& file) {
  return parse_scene(read_file(file, kLargestScene), file.string());
}

}  // namespace polhode
