// SPDX-License-Identifier: MIT
// A scene file as values. All later stages start from it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "frame/view_spec.h"
#include "model/body_spec.h"
#include "motion/motion_spec.h"
#include "video/video_spec.h"

namespace polhode {

struct ScenePanel;

// All lengths, times and angles are in SI units and radians.
struct Scene {
  int format = 1;  // version of the scene format; only 1 is known
  std::string title;
  BodySpec body;
  MotionSpec motion;
  NumericsSpec numerics;
  CameraSpec camera;
  ShowSpec show;
  std::vector<ShotSpec> shots;
  std::vector<StoryStep> story;
  VideoSpec video;
  ThemeSpec theme;  // shares the [video] table

  std::string file;  // the file it was read from, as the user named it
  // Line of each key in it, and of each table in a list, by dotted path without unit suffixes.
  std::map<std::string, int> lines;
  // Key, or table of keys -> where its value comes from, if not from that file: an option, such as
  // "--size" or "--set video.size" (a place without a file), or a film file.
  std::map<std::string, Place> options;

  // Of a film of several scenes (scene/film_file.h), all of them; the scene itself is then the
  // first with the film's title. Empty: it is a scene by itself.
  std::vector<ScenePanel> panels;
  std::string film_file;     // of such a film, as the user named it
  bool same_cameras = true;  // one camera shows all panels
  bool same_scales = true;   // vectors have one scale in all panels
};

// One of several scenes that are shown side by side.
struct ScenePanel {
  std::string caption;
  Scene scene;  // without panels
};

// Throws Error (input), with the film file, for a scene with panels; for what works on one motion.
void refuse_panels(const Scene& scene);

// Calls `work` on a scene and on the scenes of its panels.
template <class AnyScene, class Work>
void for_each_scene(AnyScene& scene, const Work& work) {
  work(scene);
  for (auto& panel : scene.panels)
    work(panel.scene);
}

template <class Visitor>
void fields(Visitor& v, Scene& s) {
  v.field("format", s.format, Doc{"version of the scene format", Unit::none, Range{1, 1}});
  v.field("title", s.title, Doc{"title of the scene"});
  v.required("body", s.body, Doc{"how the mass of the body is distributed, and how it looks"});
  v.field(
      "motion", s.motion, Doc{"how the body is held, how it starts, and which loads act on it"});
  v.field("numerics", s.numerics, Doc{"how the motion is computed; usually left out"});
  v.field("camera", s.camera, Doc{"the camera"});
  v.field("show", s.show, Doc{"what is drawn"});
  v.field("shots", s.shots, Doc{"further cameras, each from a time on"});
  v.field(
      "story", s.story, Doc{"steps with pauses, captions, and elements that appear and disappear"});
  v.merged("video", s.video, s.theme, Doc{"size, frame rate, time scale and colours of the film"});
}

// Reads a scene, or the scenes of a film file, and their mesh files. Throws Error (input) as
// read_file (base/system/atomic_file.h) and parse_toml (scene/toml_text.h) do, and with file, line
// and key as Reader (scene/reader.h) and load_meshes (model/solids.h) do; and as load_film
// (scene/film_file.h) does. Whether the values together make sense is checked later, by make_model
// and start_state. Keys are dotted paths; lists count from 0: "body.parts[1].mass".
Scene load_scene(const std::filesystem::path& file);
// A value that replaces the one in the file: `--set KEY=VALUE`. The key is a path as the file could
// spell it, such as "motion.spin.body[2]" or "body.solid.radius_cm"; the value is TOML, or words
// that count as text.
struct Setting {
  std::string key, value;
};
// Throws Error (input), without a place, for text that is not KEY=VALUE.
Setting parse_setting(const std::string& text);
// Its key in errors: "--set KEY".
std::string option_of(const Setting& setting);
// Numbers that replace those in the file, by paths of keys likewise.
using Replacements = std::vector<std::pair<std::string, double>>;
// Reads a scene with these settings and then these numbers, as if they stood in the file; keys that
// it lacks are added. Scene::options names the settings. Also throws Error (input): with
// option_of() the setting as key for a value that the key cannot have, a key that is none, and an
// entry of a list that does not exist; without a place for a path of a number that is no key or
// leads to something else.
Scene load_scene(const std::filesystem::path& file,
                 const std::vector<Setting>& settings,
                 const Replacements& numbers = {});
// The number at such a path, in the unit of its spelling; absent if there is none. Throws Error
// (input) as read_file and parse_toml do, as load_scene does for settings, and, without a place,
// for a path that is not a key.
std::optional<double> number_in_scene(const std::filesystem::path& file,
                                      const std::vector<Setting>& settings,
                                      const std::string& path);
// A scene from a text in memory; `name` is the file name for messages. Mesh files are not read.
// Throws Error (input) as parse_toml and Reader do.
Scene parse_scene(std::string_view text, const std::string& name);
// The files that a scene names, its meshes, without opening them; of a film file also its scenes,
// which are read. As spelled there, relative to the folder of the file. Throws Error (input) as
// load_scene does for these files.
std::vector<std::string> named_files(const std::filesystem::path& file);
// The paths of the files that a scene was read from: its own, and those of its meshes and panels.
std::vector<std::filesystem::path> input_files(const Scene& scene);

// The line of a key such as "body.parts[1].radius", or else of the innermost key around it that is
// in the file; 0 if there is none. For errors found after reading.
int line_of(const Scene& scene, const std::string& key);

// The hash (content_hash() in base/hash.h) of the scene's values, defaults included, and of its
// meshes. Comments, order and the spelling of units do not change it, nor does the name of the
// scene file.
std::string scene_hash(const Scene& scene);

}  // namespace polhode
