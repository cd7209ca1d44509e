// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/at_place.h"
#include "base/hash.h"
#include "base/system/atomic_file.h"
#include "model/solids.h"
#include "scene/key_path.h"
#include "scene/reader.h"
#include "scene/toml_text.h"

namespace polhode {
namespace {

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

// is the first path, in whatever units, the second or inside of it?
bool is_within(const std::string& path, const std::string& around) {
  const std::string inner = without_suffixes(path), outer = without_suffixes(around);
  return inner.starts_with(outer) &&
         (inner.size() == outer.size() || inner[outer.size()] == '.' || inner[outer.size()] == '[');
}

// the message of an error inside a setting, with its key unless that is the setting's own
std::string about(const Error& error, const Setting& setting) {
  if (error.place().key == setting.key) return error.message();
  return fmt::format("{}: {}", error.place().key, error.message());
}

// the file with these settings
toml::table tree_of(const std::filesystem::path& file, const std::vector<Setting>& settings) {
  toml::table tree = parse_toml(read_file(file, kLargestScene), file.string());
  for (const Setting& setting : settings) {
    at_place({{}, 0, option_of(setting)}, [&] { replace_value(tree, setting.key, setting.value); });
  }
  return tree;
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

Setting parse_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) {
    throw input_error("'{}' is no KEY=VALUE; write motion.spin.body[2]=40 or the like",
                      cut(text, 60));
  }
  const auto trimmed = [](const std::string& part) {
    const std::size_t first = part.find_first_not_of(" \t");
    return first == std::string::npos
               ? std::string()
               : part.substr(first, part.find_last_not_of(" \t") + 1 - first);
  };
  return {trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))};
}

std::string option_of(const Setting& setting) {
  return "--set " + setting.key;
}

Scene load_scene(const std::filesystem::path& file) {
  return load_scene(file, {}, {});
}

std::optional<double> number_in_scene(const std::filesystem::path& file,
                                      const std::vector<Setting>& settings,
                                      const std::string& path) {
  const toml::table tree = tree_of(file, settings);
  const toml::node* node = node_at(tree, path);
  return node == nullptr ? std::nullopt : node->value<double>();
}

Scene load_scene(const std::filesystem::path& file,
                 const std::vector<Setting>& settings,
                 const Replacements& numbers) {
  toml::table tree = tree_of(file, settings);
  for (const auto& [path, value] : numbers)
    replace_number(tree, path, value);
  Scene scene;
  try {
    scene = scene_from(tree, file.string());
  } catch (const Error& error) {
    for (const Setting& setting : settings) {
      if (is_within(error.place().key, setting.key))
        throw Error(error.fault(), about(error, setting), {{}, 0, option_of(setting)});
    }
    throw;
  }
  for (const Setting& setting : settings) {
    const std::string key = without_suffixes(setting.key);
    // what it brings has no line
    std::erase_if(scene.lines, [&](const auto& line) { return is_within(line.first, key); });
    scene.options[key] = option_of(setting);
  }

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
