// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/at_place.h"
#include "scene/film_file.h"
#include "scene/key_path.h"
#include "scene/scene_tree.h"
#include "scene/toml_text.h"

namespace polhode {

Scene parse_scene(std::string_view text, const std::string& name) {
  return scene_of(parse_toml(text, name), name);
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
  toml::table tree = read_tree(file);
  for (const Setting& setting : settings) {
    const Change change = change_of(setting);
    at_place(change.place, [&] { change.apply(tree); });
  }
  const toml::node* node = node_at(tree, path);
  return node == nullptr ? std::nullopt : node->value<double>();
}

Scene load_scene(const std::filesystem::path& file,
                 const std::vector<Setting>& settings,
                 const Replacements& numbers) {
  toml::table tree = read_tree(file);
  if (is_film(tree)) {
    Scene film = load_film(std::move(tree), file, settings);
    if (!numbers.empty()) refuse_panels(film);
    return film;
  }
  std::vector<Change> changes;
  for (const Setting& setting : settings)
    changes.push_back(change_of(setting));
  for (const auto& [path, value] : numbers) {
    changes.push_back({path, {}, [path, value](toml::table& of) {
                         replace_number(of, path, value);
                       }});
  }
  return changed_scene(std::move(tree), file, changes);
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

std::vector<std::string> named_files(const std::filesystem::path& file) {
  const toml::table tree = read_tree(file);
  if (!is_film(tree)) return meshes_of(scene_of(tree, file.string()));
  std::vector<std::string> names;
  for (const std::string& scene : scenes_of_film(tree, file)) {
    const std::filesystem::path beside = file.parent_path() / scene;
    names.push_back(scene);
    for (const std::string& mesh : meshes_of(scene_of(read_tree(beside), beside.string())))
      names.push_back((std::filesystem::path(scene).parent_path() / mesh).string());
  }
  return names;
}

std::vector<std::filesystem::path> input_files(const Scene& scene) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const Scene& one) {
    const std::filesystem::path file = one.file;
    files.push_back(file);
    for (const std::string& mesh : meshes_of(one))
      files.push_back(file.parent_path() / mesh);
  };
  if (scene.panels.empty()) {
    add(scene);
    return files;
  }
  files.emplace_back(scene.film_file);
  for (const ScenePanel& panel : scene.panels)
    add(panel.scene);
  return files;
}

void refuse_panels(const Scene& scene) {
  if (scene.panels.empty()) return;
  throw input_error("is a film of {} scenes; name one of them, such as {}",
                    scene.panels.size(),
                    scene.panels.front().scene.file)
      .at({scene.film_file, 0, {}});
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
