// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/hash.h"
#include "base/system/atomic_file.h"
#include "model/solids.h"
#include "scene/reader.h"
#include "scene/toml_text.h"

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

// "motion.spin.body[2]" to its parts "motion", "spin", "body" and 2
struct PathPart {
  std::string key;
  long index = -1;  // in the list of the part before; -1: a key
};
std::vector<PathPart> parts_of(const std::string& path) {
  std::vector<PathPart> parts;
  for (std::size_t i = 0; i < path.size();) {
    if (path[i] == '[') {
      const std::size_t end = path.find(']', i);
      const std::string inside = path.substr(i + 1, end == std::string::npos ? end : end - i - 1);
      const bool digits = !inside.empty() && inside.size() < 6 &&
                          inside.find_first_not_of("0123456789") == std::string::npos;
      if (end == std::string::npos || !digits)
        throw input_error("'{}' is not a key; write motion.spin.body[2] or the like", path);
      parts.push_back({"", std::stol(inside)});
      i = end + 1;
    } else {
      if (path[i] == '.') ++i;
      const std::size_t end = std::min(path.find_first_of(".[", i), path.size());
      if (end == i)
        throw input_error("'{}' is not a key; write motion.spin.body[2] or the like", path);
      parts.push_back({path.substr(i, end - i), -1});
      i = end;
    }
  }
  return parts;
}

// the node inside `node` that a part names; null if it is not there
toml::node* inside(toml::node& node, const PathPart& part) {
  if (part.index < 0) {
    toml::table* table = node.as_table();
    return table == nullptr ? nullptr : table->get(part.key);
  }
  toml::array* array = node.as_array();
  return array == nullptr ? nullptr : array->get(static_cast<std::size_t>(part.index));
}

// a key that is not there yet is made, for the strict reader to judge; a place in a list is not
void replace_number(toml::table& tree, const std::string& path, double value) {
  const std::vector<PathPart> parts = parts_of(path);
  if (parts.empty()) throw input_error("'' is not a key");
  toml::node* node = &tree;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PathPart& part = parts[i];
    const bool last = i + 1 == parts.size();
    toml::node* next = inside(*node, part);
    toml::table* table = node->as_table();
    if (part.index >= 0) {
      if (next == nullptr || (last && !next->is_number()))
        throw input_error("the scene has no number at '{}'", path);
      if (last) {
        toml::array& array = *node->as_array();
        const auto place = array.begin() + part.index;
        array.replace(place, value);
        return;
      }
    } else if (table == nullptr || (last && next != nullptr && !next->is_number())) {
      throw input_error("the scene has no number at '{}'", path);
    } else if (last) {
      table->insert_or_assign(part.key, value);
      return;
    } else if (next == nullptr) {
      next = &table->insert_or_assign(part.key, toml::table{}).first->second;
    }
    node = next;
  }
}

Scene scene_from(const toml::table& tree, const std::string& name) {
  Scene scene;
  scene.file = name;
  Reader reader(tree, {name, 0, {}}, keys_of<Scene>());
  reader.read_tables({tree, {name, 0, {}}, suffixes_of(Unit::none).front()}, scene);
  record_lines(tree, "", scene.lines);
  return scene;
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& name) {
  return scene_from(parse_toml(text, name), name);
}

Scene load_scene(const std::filesystem::path& file) {
  return load_scene(file, {});
}

std::optional<double> number_in_scene(const std::filesystem::path& file, const std::string& path) {
  toml::table tree = parse_toml(read_file(file, kLargestScene), file.string());
  toml::node* node = &tree;
  for (const PathPart& part : parts_of(path)) {
    node = inside(*node, part);
    if (node == nullptr) return {};
  }
  return node->value<double>();
}

Scene load_scene(const std::filesystem::path& file, const Replacements& numbers) {
  toml::table tree = parse_toml(read_file(file, kLargestScene), file.string());
  for (const auto& [path, value] : numbers)
    replace_number(tree, path, value);
  Scene scene = scene_from(tree, file.string());

  // the files that it names stand beside it
  try {
    load_meshes(scene.body, file.parent_path());
  } catch (const Error& error) {
    throw error.at({scene.file, line_of(scene, error.place().key), {}});
  }
  return scene;
}

namespace {

std::vector<std::string> meshes_of(const Scene& scene) {
  std::vector<std::string> names;
  const auto add = [&](const SolidSpec& solid) {
    if (solid.kind == "mesh" && solid.file) names.push_back(*solid.file);
  };
  if (scene.body.solid) add(*scene.body.solid);
  for (const auto& part : scene.body.parts)
    add(part);
  if (scene.body.look) add(*scene.body.look);
  return names;
}

}  // namespace

std::vector<std::string> mesh_files(const std::filesystem::path& file) {
  return meshes_of(
      scene_from(parse_toml(read_file(file, kLargestScene), file.string()), file.string()));
}

std::vector<std::filesystem::path> input_files(const Scene& scene) {
  const std::filesystem::path file = scene.file;
  std::vector<std::filesystem::path> files = {file};
  for (const std::string& mesh : meshes_of(scene))
    files.push_back(file.parent_path() / mesh);
  return files;
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
