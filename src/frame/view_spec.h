// SPDX-License-Identifier: MIT
// The [camera] and [show] tables of a scene, and the looks part of [video].
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "math/notation.h"
#include "motion/recorded.h"

namespace polhode {

// Where the picture is taken from. Absent eye: the camera frames the whole film by itself.
struct CameraSpec {
  std::optional<Vec3> eye;          // m, space axes
  std::optional<Vec3> target;       // m, space axes; in the middle of the picture
  double fov = 30.0 * kPi / 180.0;  // vertical field of view, rad
  std::optional<Vec3> direction;    // from the scene towards the automatic camera
  double orbit = 0.0;               // about the vertical through the target, rad per s of film
  std::string follow = "none";      // a name from follow_names(): what the camera moves with
};

// "none", or what the camera goes along with: "center" the reference point, "body" every turn of
// the body, "momentum" the direction of L, along which it looks.
std::vector<std::string> follow_names();

// A camera from some moment on.
struct ShotSpec {
  std::string name;   // for people
  double at = 0.0;    // s of the motion
  double move = 0.0;  // s of film in which the camera goes there; 0: a cut
  CameraSpec camera;
};

// A step of an explanation.
struct StoryStep {
  double at = 0.0;                     // s of the motion
  double hold = 0.0;                   // the motion stands still for so many s of film
  double fade = 0.5;                   // s of film in which things come and go
  std::vector<std::string> show;       // names of [show] that come now, and were not there before
  std::vector<std::string> hide;       // that go
  std::optional<std::string> caption;  // words from now on; "" for none
};

// Where an automatic camera stands when the scene does not say: in front, to the right, above.
inline const Vec3 kDefaultDirection(0.82, 0.46, 0.34);

// What is drawn: names of the table in frame/elements.h. Absent: the scene's kind decides.
struct ShowSpec {
  std::map<std::string, std::optional<bool>> asked;
  std::vector<Vec3> points;   // of the body, drawn as balls with their vectors, m
  double body_opacity = 1.0;  // under 1: what is inside the body is seen through it
  bool labels = true;         // names beside vectors
  bool title = false;         // the scene's title, above
  bool clock = true;          // the time of the motion, and the scale of time if it is not 1
  std::string caption;        // a line below; empty: none
  double text_size = 1.0;     // all text is enlarged by this
  std::vector<std::string> views = {"space"};  // side by side: "space", "body"
  std::vector<std::string> plots;              // names from recorded_names(), beside the picture
  std::string material = "plain";              // a name from material_names()
  std::vector<Vec3> trail_points;              // of the body, whose paths are drawn, m
  std::optional<double> trail_s;  // paths are drawn so far back; absent: from the start, s
  int ghost_count = 5;            // how many former bodies are drawn
  std::optional<double> ghost_s;  // so far apart in time; absent: a 40th of the motion, s

  std::optional<bool>& operator[](const std::string& name) { return asked[name]; }
};

// The table's names, for the scene's keys.
struct ShowName {
  std::string name;
  std::string doc;
};
std::vector<ShowName> show_names();
std::vector<std::string> element_names();

// Colours of the picture.
struct ThemeSpec {
  std::string theme = "dark";             // a name from theme_names()
  std::optional<std::string> background;  // "#rrggbb"
};

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
