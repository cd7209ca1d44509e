// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/hash.h"
#include "model/solids.h"
#include "scene/reader.h"
#include "scene/text.h"

namespace polhode {
namespace {

// a key without the unit that it is spelled in: "radius_cm" is "radius"
std::string without_suffix(const std::string& key) {
  for (const std::string& suffix : all_suffixes()) {
    if (key.size() > suffix.size() && key.ends_with(suffix)) {
      return key.substr(0, key.size() - suffix.size());
    }
  }
  return key;
}

void record_lines(const toml::node& node,
                  const std::string& path,
                  std::map<std::string, int>& lines) {
  if (const toml::array* array = node.as_array()) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      // single numbers stand on the line of their list; a mesh of them would fill the memory
      if (array->get(i)->is_value()) continue;
      const std::string inside = fmt::format("{}[{}]", path, i);
      lines.emplace(inside, static_cast<int>(array->get(i)->source().begin.line));
      record_lines(*array->get(i), inside, lines);
    }
  }
  const toml::table* table = node.as_table();
  if (table == nullptr) return;
  for (const auto& [key, value] : *table) {
    const std::string name(key.str());
    const std::string inside = (path.empty() ? "" : path + ".") + without_suffix(name);
    lines.emplace(inside, static_cast<int>(key.source().begin.line));
    record_lines(value, inside, lines);
  }
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& name) {
  const toml::table tree = parse_toml(text, name);
  Scene scene;
  scene.file = name;
  Reader reader(tree, {name, 0, {}}, keys_of<Scene>());
  reader.read_tables({tree, {name, 0, {}}, suffixes_of(Unit::none).front()}, scene);
  record_lines(tree, "", scene.lines);
  return scene;
}

Scene load_scene(const std::filesystem::path& file) {
  Scene scene = parse_scene(read_file(file, kLargestScene), file.string());

  // the files that it names stand beside it
  try {
    load_meshes(scene.body, file.parent_path());
  } catch (const Error& error) {
    throw error.at({scene.file, line_of(scene, error.place().key), {}});
  }
  return scene;
}

int line_of(const Scene& scene, const std::string& key) {
  std::string path = key;
  while (!path.empty()) {
    const auto found = scene.lines.find(path);
    if (found != scene.lines.end()) return found->second;
    const std::size_t end = path.find_last_of(".[");
    path = end == std::string::npos ? "" : path.substr(0, end);
  }
  return 0;
}

}  // namespace polhode
