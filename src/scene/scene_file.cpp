// SPDX-License-Identifier: MIT
#include "scene/scene_file.h"

#include "base/at_place.h"
#include "scene/film_file.h"
#include "scene/key_path.h"
#include "scene/scene_tree.h"
#include "scene/toml_text.h"

namespace polhode {

Scene parse_scene(std::string_view text, const std::string& name) {
  return scene_of(parse_toml(text, name), name);
}

Scene parse_scene(std::string_view text,
                  const std::string& name,
                  const std::vector<Setting>& settings) {
  std::vector<Change> changes;
  changes.reserve(settings.size());
  for (const Setting& setting : settings)
    changes.push_back(change_of(setting));
  return changed_scene_of(parse_toml(text, name), name, changes);
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
  changes.reserve(settings.size() + numbers.size());
  for (const Setting& setting : settings)
    changes.push_back(change_of(setting));
  for (const auto& number : numbers) {
    const Place place{{}, 0, fmt::format("{} = {:g}", number.first, number.second)};
    changes.push_back({number.first, place, [number](toml::table& of) {
                         replace_number(of, number.first, number.second);
                       }});
  }
  return changed_scene(std::move(tree), file, changes);
}

std::vector<std::string> named_files(const std::filesystem::path& file) {
  const toml::table tree = read_tree(file);
  if (!is_film(tree)) return mesh_names(scene_of(tree, file.string()));
  std::vector<std::string> names;
  for (const std::string& scene : scenes_of_film(tree, file)) {
    const std::filesystem::path beside = file.parent_path() / scene;
    names.push_back(scene);
    for (const std::string& mesh : mesh_names(scene_of(read_tree(beside), beside.string())))
      names.push_back((std::filesystem::path(scene).parent_path() / mesh).string());
  }
  return names;
}

void refuse_given(const Scene& scene, const std::string& key, const std::string& why) {
  for (const auto& [given, place] : scene.options) {
    if (is_within(given, key)) throw input_error("{}", why).at({{}, 0, given});
  }
}

void refuse_given_for_panels(const Scene& scene, const std::string& key) {
  for (const auto& [changed, place] : scene.options) {
    if (place.key.starts_with("sweep.")) refuse_overlap(changed, key);
    if (place.key.starts_with("--set panel[") && keys_overlap(changed, key))
      throw input_error("cannot be given beside '{}'", place.key);
  }
}

}  // namespace polhode
