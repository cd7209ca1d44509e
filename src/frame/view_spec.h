// SPDX-License-Identifier: MIT
// The [camera], [show], [[shots]] and [[story]] tables of a scene, and the colours in [video].
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "math/notation.h"
#include "motion/recorded.h"

namespace polhode {

// A camera. Without eye, it frames the whole film automatically.
struct CameraSpec {
  std::optional<Vec3> eye;          // position in S, m
  std::optional<Vec3> target;       // point in the middle of the picture, in S, m
  double fov = 30.0 * kPi / 180.0;  // vertical field of view, rad
  std::optional<Vec3> direction;    // from the scene towards an automatic camera, in S
  double orbit = 0.0;               // about the vertical through the target, rad per s of film
  std::string follow = "none";      // one of follow_names(): what the camera moves with
};

// What a camera can move with: "none"; "center", the reference point; "body", the attitude of the
// body too; "momentum", the direction of L too.
std::vector<std::string> follow_names();

// A shot: the camera used from some time on.
struct ShotSpec {
  std::string name;   // chapter title
  double at = 0.0;    // s of motion
  double move = 0.0;  // s of film in which the camera moves there; 0: a cut
  CameraSpec camera;
};

// A step of the story.
struct StoryStep {
  double at = 0.0;                     // s of motion
  double hold = 0.0;                   // the motion stands still for this long, s of film
  double fade = 0.5;                   // how long elements fade in and out, s of film
  std::vector<std::string> show;       // elements that appear now and are hidden before
  std::vector<std::string> hide;       // elements that disappear now
  std::optional<std::string> caption;  // caption from now on; "": none
};

// The default direction towards an automatic camera: in front, to the right, above.
inline const Vec3 kDefaultDirection(0.82, 0.46, 0.34);

// What is drawn.
struct ShowSpec {
  // By name of the element (frame/elements.h); absent: Element::by_default decides.
  std::map<std::string, std::optional<bool>> asked;
  std::vector<Vec3> points;   // points drawn as balls with position vectors, in B, m
  double body_opacity = 1.0;  // below 1: the body is translucent
  bool labels = true;         // the names of vectors
  bool title = false;         // the scene's title, at the top
  bool clock = true;          // the time of the motion, and the time scale if it is not 1
  std::string caption;        // a line at the bottom; empty: none
  double text_size = 1.0;     // scales all text
  std::vector<std::string> views = {"space"};  // panels: "space", "body"
  std::vector<std::string> plots;              // names from recorded_names()
  std::string material = "plain";              // one of material_names()
  std::vector<Vec3> trail_points;              // points whose paths are drawn, in B, m
  std::optional<double> trail_s;  // s of motion that paths cover; absent: from the start
  int ghost_count = 5;            // how many earlier positions of the body are drawn
  std::optional<double> ghost_s;  // s of motion between them; absent: a 40th of the motion

  // Whether the scene asks for the element; absent: it does not say.
  std::optional<bool>& operator[](const std::string& name) { return asked[name]; }
};

// The name of an element and its description, for the keys of [show].
struct ShowName {
  std::string name;
  std::string doc;
};
// From the table in frame/elements.cpp, in its order.
std::vector<ShowName> show_names();
std::vector<std::string> element_names();

// The colours of the picture.
struct ThemeSpec {
  std::string theme = "dark";             // one of theme_names()
  std::optional<std::string> background;  // "#rrggbb"
};

// The names of the tables in frame/theme.cpp.
std::vector<std::string> theme_names();
std::vector<std::string> material_names();

template <class Visitor>
void fields(Visitor& v, CameraSpec& s) {
  v.at_most_one_of({"eye", "direction"});
  v.field(
      "eye", s.eye, Doc{"where the camera is; absent: it frames the film by itself", Unit::length});
  v.field("target",
          s.target,
          Doc{"what it looks at; absent: the middle of what is drawn", Unit::length});
  v.field("fov", s.fov, Doc{"vertical field of view", Unit::angle, Range{0.01, 2.6}});
  v.field("direction",
          s.direction,
          Doc{"from the scene towards an automatic camera; absent: [0.82, 0.46, 0.34]"});
  v.field("orbit",
          s.orbit,
          Doc{"how fast the camera goes round the vertical, per second of film",
              Unit::angular_velocity});
  v.field("follow", s.follow, Doc{"what it moves with", Unit::none, kAny, follow_names()});
}

template <class Visitor>
void fields(Visitor& v, ShotSpec& s) {
  v.field("name", s.name, Doc{"what this shot is called"});
  v.required("at", s.at, Doc{"from when on, in the motion", Unit::time, kNonNegative});
  v.field("move",
          s.move,
          Doc{"how long the camera takes to get there, in the film; 0: a cut",
              Unit::time,
              kNonNegative});
  fields(v, s.camera);
}

template <class Visitor>
void fields(Visitor& v, StoryStep& s) {
  v.required("at", s.at, Doc{"when, in the motion", Unit::time, kNonNegative});
  v.field("hold",
          s.hold,
          Doc{"how long the motion stands still, in the film", Unit::time, kNonNegative});
  v.field("fade",
          s.fade,
          Doc{"how long things take to come and go, in the film", Unit::time, kNonNegative});
  v.field("show", s.show, Doc{"what comes now", Unit::none, kAny, element_names()});
  v.field("hide", s.hide, Doc{"what goes now", Unit::none, kAny, element_names()});
  v.field("caption", s.caption, Doc{"words from now on; empty: none"});
}

template <class Visitor>
void fields(Visitor& v, ShowSpec& s) {
  for (const auto& [name, doc] : show_names())
    v.field(name.c_str(), s.asked[name], Doc{doc});
  v.field("body_opacity",
          s.body_opacity,
          Doc{"1: solid; less: what is inside the body is seen through it, without cones",
              Unit::none,
              Range{0.05, 1.0}});
  v.field("material",
          s.material,
          Doc{"how the body's surface looks", Unit::none, kAny, material_names()});
  v.field("trail_points",
          s.trail_points,
          Doc{"points of the body whose paths are drawn", Unit::length});
  v.field("trail_length",
          s.trail_s,
          Doc{"how far back in time paths are drawn; absent: to the start", Unit::time, kPositive});
  v.field("ghost_count",
          s.ghost_count,
          Doc{"how many former bodies are drawn", Unit::none, Range{1, 50}});
  v.field(
      "ghost_interval",
      s.ghost_s,
      Doc{"how far they are apart in time; absent: a 40th of the motion", Unit::time, kPositive});
  v.field("views",
          s.views,
          Doc{"pictures side by side: of space, and as the body sees it",
              Unit::none,
              kAny,
              {"space", "body"}});
  v.field("plots",
          s.plots,
          Doc{"quantities over time, beside the picture", Unit::none, kAny, recorded_names()});
  v.field("labels", s.labels, Doc{"names beside vectors"});
  v.field("title", s.title, Doc{"the scene's title, at the top"});
  v.field("clock", s.clock, Doc{"the time of the motion, and how much slower it is shown"});
  v.field("caption", s.caption, Doc{"words at the bottom; empty: none"});
  v.field(
      "text_size", s.text_size, Doc{"all text is enlarged by this", Unit::none, Range{0.3, 4.0}});
  v.field("points", s.points, Doc{"points of the body with their vectors", Unit::length});
}

template <class Visitor>
void fields(Visitor& v, ThemeSpec& s) {
  v.field("theme", s.theme, Doc{"colours", Unit::none, kAny, theme_names()});
  v.field("background", s.background, Doc{.text = "background colour, \"#rrggbb\"", .color = true});
}

}  // namespace polhode
