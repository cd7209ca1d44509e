// SPDX-License-Identifier: MIT
// A scene file as values. All later stages start from it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
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
  bool in_turn = false;      // panels follow one another, each in the whole frame
};

// One of several scenes that are shown side by side, or in turn.
struct ScenePanel {
  std::string caption;
  Scene scene;  // without panels
};

// The motion time that a film shows, s: that of all panels together, if they follow one another.
double shown_duration(const Scene& scene);

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

// The mesh files that a scene names, as spelled there.
std::vector<std::string> mesh_names(const Scene& scene);
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
