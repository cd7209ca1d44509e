// SPDX-License-Identifier: MIT
#include "scene/scene_tree.h"

#include <fmt/format.h>

#include "base/at_place.h"
#include "base/system/atomic_file.h"
#include "model/solids.h"
#include "scene/key_path.h"
#include "scene/reader.h"
#include "scene/setting.h"
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

// the message of an error inside a change, with its key unless that is the change's own
std::string about(const Error& error, const std::string& path) {
  if (error.place().key == path) return error.message();
  return fmt::format("{}: {}", error.place().key, error.message());
}

}  // namespace

Change change_of(const Setting& setting) {
  return {setting.key, {{}, 0, option_of(setting)}, [setting](toml::table& tree) {
            replace_value(tree, setting.key, setting.value);
          }};
}

Error blamed(const Error& error, const std::vector<Change>& changes) {
  // the last one that says something of it
  const std::string& key = error.place().key;
  for (auto change = changes.rbegin(); change != changes.rend(); ++change) {
    if (change->place.key.empty()) continue;
    if (is_within(key, change->path))
      return {error.fault(), about(error, change->path), change->place};
  }
  for (auto change = changes.rbegin(); change != changes.rend(); ++change) {
    if (change->place.key.empty() || key.empty() || !is_within(change->path, key)) continue;
    // a table that the change has brought, or one of the file that it does not go with
    if (error.place().line == 0) return {error.fault(), about(error, change->path), change->place};
    return {error.fault(),
            fmt::format("{}; '{}' is set from outside this file", error.message(), change->path),
            error.place()};
  }
  return error;
}

bool is_within(const std::string& path, const std::string& around) {
  const std::string inner = without_suffixes(path), outer = without_suffixes(around);
  return inner.starts_with(outer) &&
         (inner.size() == outer.size() || inner[outer.size()] == '.' || inner[outer.size()] == '[');
}

bool keys_overlap(const std::string& one, const std::string& other) {
  return is_within(one, other) || is_within(other, one);
}

void refuse_overlap(const std::string& swept, const std::string& key) {
  if (!keys_overlap(swept, key)) return;
  throw input_error("the sweep changes '{}'; give it other values: --set 'sweep.values=[…]'",
                    swept);
}

toml::table read_tree(const std::filesystem::path& file) {
  return parse_toml(read_input(file, kLargestScene), file.string());
}

Scene scene_of(const toml::table& tree, const std::string& name) {
  Scene scene;
  scene.file = name;
  Reader reader(tree, {name, 0, {}}, keys_of<Scene>());
  reader.read_tables({tree, {name, 0, {}}, suffixes_of(Unit::none).front()}, scene);
  record_lines(tree, "", scene.lines);
  return scene;
}

Scene changed_scene_of(toml::table tree,
                       const std::string& name,
                       const std::vector<Change>& changes) {
  for (const Change& change : changes)
    at_place(change.place, [&] { change.apply(tree); });
  Scene scene;
  try {
    scene = scene_of(tree, name);
  } catch (const Error& error) {
    throw blamed(error, changes);
  }
  for (const Change& change : changes) {
    if (change.place.key.empty()) continue;
    const std::string key = without_suffixes(change.path);
    // what it brings has no line
    std::erase_if(scene.lines, [&](const auto& line) { return is_within(line.first, key); });
    scene.options[key] = change.place;
  }
  return scene;
}

Scene changed_scene(toml::table tree,
                    const std::filesystem::path& file,
                    const std::vector<Change>& changes) {
  Scene scene = changed_scene_of(std::move(tree), file.string(), changes);
  // the files that it names stand beside it
  try {
    load_meshes(scene.body, file.parent_path());
  } catch (const Error& error) {
    throw error.at({scene.file, line_of(scene, error.place().key), {}});
  }
  return scene;
}

}  // namespace polhode
