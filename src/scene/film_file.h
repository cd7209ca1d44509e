// SPDX-License-Identifier: MIT
// Film files: several scenes side by side, on one clock, or one after the other.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "base/fields.h"
#include "scene/scene.h"
#include "scene/setting.h"

namespace polhode {

// A [[panel]]: a scene, and what is different in it.
struct PanelSpec {
  std::string scene;
  std::optional<std::string> caption;
  toml::table set;
};
template <class Visitor>
void fields(Visitor& v, PanelSpec& s) {
  v.required("scene", s.scene, Doc{"the scene's file, relative to this one"});
  v.field("caption", s.caption, Doc{"heading of the panel; by default the title of the scene"});
  v.field("set",
          s.set,
          Doc{"values that replace those of the scene, by their keys, such as "
              "{ \"motion.duration\" = 5 }"});
}

// A [sweep]: one scene with several values of one key, a panel each.
struct SweepSpec {
  std::string scene;
  std::string key;
  toml::array values;
  std::optional<std::string> caption;
};
template <class Visitor>
void fields(Visitor& v, SweepSpec& s) {
  v.required("scene", s.scene, Doc{"the scene's file, relative to this one"});
  v.required("key", s.key, Doc{"the key that changes, such as \"motion.spin.body[2]\""});
  v.required("values", s.values, Doc{"its values, a panel each"});
  v.field("caption",
          s.caption,
          Doc{"heading of the panels, with {} for the value; by default the key and its value"});
}

// What a film file has besides the tables of a scene that hold for all panels.
struct FilmFile {
  int format = 1;
  std::string title;
  std::vector<PanelSpec> panel;
  std::optional<SweepSpec> sweep;
  std::string arrange = "side_by_side";
  std::string cameras = "same";
  std::string scales = "same";
};
template <class Visitor>
void fields(Visitor& v, FilmFile& s) {
  v.field("format", s.format, Doc{"version of the format", Unit::none, Range{1, 1}});
  v.field("title", s.title, Doc{"title of the film"});
  v.field("panel", s.panel, Doc{"the scenes, side by side"});
  v.field("sweep", s.sweep, Doc{"one scene with several values of one key"});
  v.exactly_one_of({"panel", "sweep"});
  v.field("arrange",
          s.arrange,
          Doc{"panels side by side, or one after the other in the whole picture",
              Unit::none,
              kAny,
              {"side_by_side", "in_turn"}});
  v.field("cameras",
          s.cameras,
          Doc{"one camera for all, or each its own", Unit::none, kAny, {"same", "own"}});
  v.field("scales",
          s.scales,
          Doc{"vectors of one scale, or as long as each scene has them",
              Unit::none,
              kAny,
              {"same", "own"}});
}

// The maximum number of panels.
inline constexpr std::size_t kMostPanels = 9;

// Whether a tree is that of a film file.
bool is_film(const toml::table& tree);

// Makes the scene of a film file: that of the first panel, with Scene::panels. Its other tables,
// and then the settings, hold for all panels; a setting of a key of FilmFile changes the film file.
// [video] and the story are those of the first panel, and all last as long as the longest, unless
// the film says otherwise. Throws Error (input) as load_scene does, and for panels of several
// views, compared methods, loops, and films.
Scene load_film(toml::table tree,
                const std::filesystem::path& file,
                const std::vector<Setting>& settings);

// The scenes that a film file names, as it spells them. Throws Error (input) as load_film does for
// the film file itself.
std::vector<std::string> scenes_of_film(toml::table tree, const std::filesystem::path& file);

}  // namespace polhode
