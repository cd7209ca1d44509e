// SPDX-License-Identifier: MIT
#include "scene/film_file.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/at_place.h"
#include "base/numbers.h"
#include "base/system/files.h"
#include "scene/key_path.h"
#include "scene/reader.h"
#include "scene/scene_tree.h"
#include "scene/setting.h"

namespace polhode {
namespace {

using Changes = std::vector<Change>;

bool is_path(const std::string& key) {
  return key.find_first_of(".[") != std::string::npos;
}

Change put(const std::string& path, const toml::node& node, const Place& place) {
  const auto holder = std::make_shared<toml::table>();
  node.visit([&](const auto& value) { holder->insert("value", value); });
  return {path, place, [path, holder](toml::table& tree) {
            replace_node(tree, path, *holder->get("value"));
          }};
}

// The values of a table, each a change. A table in it is merged with that of the scene, unless its
// key is a path.
void add_changes(const toml::table& table,
                 const std::string& path,
                 const Place& place,
                 Changes& changes) {
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    const std::string inside = path.empty() ? name : fmt::format("{}.{}", path, name);
    Place here = place;
    here.key = place.key.empty() ? inside : fmt::format("{}.{}", place.key, name);
    if (const auto line = static_cast<int>(key.source().begin.line); line > 0) here.line = line;
    if (node.is_table() && !is_path(name)) {
      add_changes(*node.as_table(), inside, here, changes);
    } else {
      changes.push_back(put(inside, node, here));
    }
  }
}

// Those of one place in their order: what they change as a whole before what is in it. Throws Error
// (input) if two give one value, whatever its unit.
Changes in_order(Changes changes) {
  constexpr std::size_t kMost = 1000;
  if (changes.size() > kMost) {
    throw input_error("sets {} values; at most {} are allowed", changes.size(), kMost)
        .at(changes.front().place);
  }
  std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
    return a.path.size() < b.path.size();
  });
  std::map<std::string, std::string> seen;  // paths as they are spelled, by those without units
  for (const Change& change : changes) {
    const auto [other, is_new] = seen.emplace(without_suffixes(change.path), change.path);
    if (is_new) continue;
    if (other->second == change.path)
      throw input_error("'{}' is given twice", change.path).at(change.place);
    throw input_error("give only one of '{}' and '{}'", other->second, change.path)
        .at(change.place);
  }
  return changes;
}

bool is_key_of_film(const std::string& name) {
  const KeyList& keys = keys_of<FilmFile>();
  return std::any_of(
      keys.keys.begin(), keys.keys.end(), [&](const Key& key) { return key.name == name; });
}

bool is_key_of_scene(const std::string& name) {
  const KeyList& keys = keys_of<Scene>();
  return std::any_of(
      keys.keys.begin(), keys.keys.end(), [&](const Key& key) { return key.name == name; });
}

// what holds for all panels, taken out of the tree
Changes take_common(toml::table& tree, const std::string& file) {
  std::vector<std::pair<std::string, int>> names;
  for (const auto& [key, node] : tree) {
    const std::string name(key.str());
    if (is_key_of_film(name) || !is_key_of_scene(name)) continue;
    names.emplace_back(name, static_cast<int>(key.source().begin.line));
  }
  Changes changes;
  for (const auto& [name, line] : names) {
    const toml::node& node = *tree.get(name);
    if (node.is_table()) {
      add_changes(*node.as_table(), name, {file, line, name}, changes);
    } else {
      changes.push_back(put(name, node, {file, line, name}));
    }
  }
  for (const auto& [name, line] : names)
    tree.erase(name);
  return in_order(std::move(changes));
}

FilmFile film_of(const toml::table& tree, const std::string& file) {
  FilmFile film;
  Reader reader(tree, {file, 0, {}}, keys_of<Scene>());
  reader.read_tables({tree, {file, 0, {}}, suffixes_of(Unit::none).front()}, film);
  return film;
}

int line_of_panel(const toml::table& tree, std::size_t i) {
  const toml::array* panels = tree["panel"].as_array();
  if (panels == nullptr) return static_cast<int>(tree["sweep"].node()->source().begin.line);
  return static_cast<int>(panels->get(i)->source().begin.line);
}

int line_of(const toml::node_view<const toml::node>& value) {
  return value ? static_cast<int>(value.node()->source().begin.line) : 0;
}

// "{} rad/s" with a value in each of its places
std::string filled(const std::string& pattern, const std::string& value) {
  constexpr std::string_view kPlace = "{}";
  std::string text = pattern;
  std::size_t at = text.find(kPlace);
  if (at == std::string::npos) return fmt::format("{} {}", pattern, value);
  for (; at != std::string::npos; at = text.find(kPlace, at + value.size())) {
    text.replace(at, kPlace.size(), value);
  }
  return text;
}

std::string text_of(const toml::node& value) {
  if (const auto* text = value.as_string()) return text->get();
  if (const auto* number = value.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* whole = value.as_integer()) return fmt::format("{}", whole->get());
  return value.value_or(false) ? "true" : "false";
}

// A panel as the file asks for it.
struct Asked {
  std::string scene;
  std::optional<std::string> caption;
  Changes changes;
  Place names_scene;  // where the file names its scene
};

std::vector<Asked> panels_of(const FilmFile& film,
                             const toml::table& tree,
                             const std::string& file) {
  std::vector<Asked> panels;
  for (std::size_t i = 0; i < film.panel.size(); ++i) {
    const PanelSpec& spec = film.panel[i];
    const int line = line_of_panel(tree, i);
    const Place names_scene{
        file, line_of(tree["panel"][i]["scene"]), fmt::format("panel[{}].scene", i)};
    Asked panel{spec.scene, spec.caption, {}, names_scene};
    add_changes(spec.set, "", {file, line, fmt::format("panel[{}].set", i)}, panel.changes);
    panel.changes = in_order(std::move(panel.changes));
    panels.push_back(std::move(panel));
  }
  if (film.sweep) {
    const SweepSpec& sweep = *film.sweep;
    for (std::size_t i = 0; i < sweep.values.size(); ++i) {
      const toml::node& value = *sweep.values.get(i);
      const Place place{
          file, line_of(tree["sweep"]["values"][i]), fmt::format("sweep.values[{}]", i)};
      // what is wrong where it is put is the key
      Change change = put(sweep.key, value, place);
      const Place at_key{file, line_of(tree["sweep"]["key"]), "sweep.key"};
      change.apply = [at_key, apply = change.apply](toml::table& scene) {
        at_place(at_key, [&] { apply(scene); });
      };
      const Place names_scene{file, line_of(tree["sweep"]["scene"]), "sweep.scene"};
      panels.push_back({sweep.scene,
                        filled(sweep.caption.value_or(sweep.key + " ="), text_of(value)),
                        {change},
                        names_scene});
    }
  }
  if (panels.size() > kMostPanels) {
    throw input_error("has {} panels; at most {} are allowed", panels.size(), kMostPanels)
        .at({file, line_of_panel(tree, 0), "panel"});
  }
  return panels;
}

// What all panels share cannot be changed in one of them.
void refuse_shared(const Changes& changes, bool same_cameras) {
  constexpr std::array<const char*, 10> kShared = {"video",
                                                   "story",
                                                   "show.clock",
                                                   "show.title",
                                                   "show.caption",
                                                   "show.labels",
                                                   "show.text_size",
                                                   "show.plots",
                                                   "format",
                                                   "title"};
  const auto refuse = [](const Change& change, const char* how) {
    throw input_error("'{}' is one for the whole film: {}", change.path, how).at(change.place);
  };
  for (const Change& change : changes) {
    for (const char* shared : kShared) {
      if (is_within(change.path, shared)) refuse(change, "set it beside the panels");
    }
    if (same_cameras && (is_within(change.path, "camera") || is_within(change.path, "shots")))
      refuse(change, "set it beside the panels, or set cameras = \"own\"");
  }
}

// what a panel cannot have
void check_panel(const Scene& scene) {
  const auto refuse_at = [&](const char* key, const Error& error) {
    Place place{scene.file, line_of(scene, key), key};
    if (const auto given = scene.options.find(key); given != scene.options.end())
      place = given->second;
    throw error.at(place);
  };
  if (!scene.numerics.compare.empty()) {
    refuse_at("numerics.compare",
              input_error("a panel shows one motion; give each method a panel, with set = {{ "
                          "\"numerics.method\" = ... }}"));
  }
  if (scene.show.views.size() > 1)
    refuse_at("show.views", input_error("a panel has one view; give each view a panel"));
  if (scene.video.loop)
    refuse_at("video.loop", input_error("several motions do not close at one time"));
}

// Where a film has a duration for all.
void refuse_own_duration(const Changes& changes) {
  for (const Change& change : changes) {
    if (is_within("motion.duration", change.path)) {
      throw input_error("'motion.duration' is given for the whole film; leave one out")
          .at(change.place);
    }
  }
}

// A sweep names its values in the headings of its panels, and all panels last equally long.
void refuse_in_sweep(const SweepSpec& sweep, const Place& at_key, const Changes& from_options) {
  if (is_within(sweep.key, "motion.duration")) {
    throw input_error("'{}' is one for the whole film; set it beside [sweep]", sweep.key)
        .at(at_key);
  }
  for (const Change& change : from_options)
    at_place(change.place, [&] { refuse_overlap(sweep.key, change.path); });
}

// A setting of what is different in one panel: "panel[1].set.motion.duration".
struct PanelSetting {
  std::size_t panel;
  std::string path;  // "motion.duration"
};
std::optional<PanelSetting> in_panel(const std::string& key) {
  constexpr std::string_view kBegin = "panel[", kEnd = "].set.";
  if (!key.starts_with(kBegin)) return {};
  const std::size_t end = key.find(kEnd, kBegin.size());
  if (end == std::string::npos) return {};
  const std::optional<int> panel =
      parse_integer(std::string_view(key).substr(kBegin.size(), end - kBegin.size()));
  if (!panel || *panel < 0) return {};
  return PanelSetting{static_cast<std::size_t>(*panel), key.substr(end + kEnd.size())};
}

// The changes that it makes; a table is merged, as it is in the file.
Changes changes_of(const PanelSetting& in, const Setting& setting, const Place& place) {
  toml::table holder;
  at_place(place, [&] { replace_value(holder, "value", setting.value); });
  const toml::node& value = *holder.get("value");
  Changes changes;
  if (value.is_table()) {
    add_changes(*value.as_table(), in.path, place, changes);
  } else {
    changes.push_back(put(in.path, value, place));
  }
  for (Change& change : changes)
    change.place = place;
  return changes;
}

// whether the changes give a value to the key, or to a table around it
bool is_given(const Changes& changes, const char* key) {
  return std::any_of(changes.begin(), changes.end(), [&](const Change& change) {
    return is_within(key, change.path);
  });
}

}  // namespace

bool is_film(const toml::table& tree) {
  return tree.contains("panel") || tree.contains("sweep");
}

Scene load_film(toml::table tree,
                const std::filesystem::path& file,
                const std::vector<Setting>& settings) {
  Changes from_options, of_film;
  std::map<std::size_t, Changes> of_panels;
  for (const Setting& setting : settings) {
    const std::string first = setting.key.substr(0, setting.key.find_first_of(".["));
    const Change change = change_of(setting);
    const toml::array* panels = tree["panel"].as_array();
    const std::optional<PanelSetting> inside = in_panel(setting.key);
    if (inside && panels != nullptr && inside->panel < panels->size()) {
      for (Change& one : changes_of(*inside, setting, change.place))
        of_panels[inside->panel].push_back(std::move(one));
    } else if (is_key_of_film(first)) {
      at_place(change.place, [&] { change.apply(tree); });
      of_film.push_back(change);
    } else {
      from_options.push_back(change);
    }
  }
  const Changes common = take_common(tree, file.string());
  const FilmFile film = [&] {
    try {
      return film_of(tree, file.string());
    } catch (const Error& error) {
      throw blamed(error, of_film);
    }
  }();

  if (film.sweep) {
    const Place at_key{file.string(), line_of(std::as_const(tree)["sweep"]["key"]), "sweep.key"};
    refuse_in_sweep(*film.sweep, at_key, from_options);
  }

  const bool own_duration =
      is_given(common, "motion.duration") || is_given(from_options, "motion.duration");
  std::vector<ScenePanel> panels;
  double longest = 0.0;
  for (const Asked& asked : panels_of(film, tree, file.string())) {
    const Changes& of_panel = of_panels[panels.size()];
    // values of the film, of the panel, of the command line, and of that for this panel
    Changes changes = common;
    for (const Changes* more :
         std::initializer_list<const Changes*>{&asked.changes, &from_options, &of_panel})
      changes.insert(changes.end(), more->begin(), more->end());
    for (const Changes* own : {&asked.changes, &of_panel})
      refuse_shared(*own, film.cameras == "same");
    if (is_given(common, "motion.duration")) refuse_own_duration(asked.changes);
    if (own_duration) refuse_own_duration(of_panel);
    const std::filesystem::path scene_file = file.parent_path() / asked.scene;
    if (!is_there(scene_file))
      throw input_error("the file '{}' does not exist", asked.scene).at(asked.names_scene);
    toml::table scene_tree = read_tree(scene_file);
    if (is_film(scene_tree)) {
      throw input_error("'{}' is a film of several scenes itself; name a scene", asked.scene)
          .at(asked.names_scene);
    }
    ScenePanel panel;
    panel.scene = changed_scene(std::move(scene_tree), scene_file, changes);
    check_panel(panel.scene);
    panel.caption = asked.caption.value_or(panel.scene.title.empty() ? scene_file.stem().string()
                                                                     : panel.scene.title);
    longest = std::max(longest, panel.scene.motion.duration);
    panels.push_back(std::move(panel));
  }

  // one clock, one story, one size, one look: those of the first, unless the film gives them to all
  const Scene first = panels.front().scene;
  for (ScenePanel& panel : panels) {
    panel.scene.video = first.video;
    panel.scene.theme = first.theme;
    if (!own_duration) panel.scene.motion.duration = longest;
    panel.scene.story = first.story;
  }
  Scene scene = panels.front().scene;
  scene.film_file = file.string();
  scene.title = film.title;
  scene.same_cameras = film.cameras == "same";
  scene.same_scales = film.scales == "same";
  scene.in_turn = film.arrange == "in_turn";
  scene.panels = std::move(panels);
  return scene;
}

std::vector<std::string> scenes_of_film(toml::table tree, const std::filesystem::path& file) {
  take_common(tree, file.string());
  std::vector<std::string> scenes;
  for (const Asked& panel : panels_of(film_of(tree, file.string()), tree, file.string()))
    scenes.push_back(panel.scene);
  return scenes;
}

}  // namespace polhode
