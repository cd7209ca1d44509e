// SPDX-License-Identifier: MIT
// The [camera], [show], [[shots]] and [[story]] tables of a scene, and the colours in [video].
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "math/notation.h"
#include "motion/diagram.h"

namespace polhode {

// A camera. Without eye, it frames the whole film automatically.
struct CameraSpec {
  std::optional<Vec3> eye;          // position in S, m; absent: automatic
  std::optional<Vec3> target;       // point in the middle of the picture, in S, m; absent: the
                                    // middle of what is drawn
  double fov = 30.0 * kPi / 180.0;  // vertical field of view, rad
  std::optional<Vec3> direction;    // from the scene towards an automatic camera, in S, of any
                                    // length; absent: kDefaultDirection, or L if it follows L
  double zoom = 1.0;                // magnifies the picture about its middle
  std::optional<double> margin;     // of an automatic camera: what stays free at each edge beside
                                    // text, fraction of the picture's height; absent: FrameMargins
  double orbit = 0.0;               // about the Z direction of S through the target (absent: the
                                    // reference point at the start), rad per s of film
  std::string follow = "auto";      // one of follow_names(): what the camera moves with
};

// What a camera can move with: "none", it stands still; "center", it moves with the reference
// point; "body", it also turns with the body; "momentum", it also turns with the direction of L;
// "upright", it moves with the reference point and sees L vertical; "auto": Composer::follow_of()
// chooses.
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

// The default direction (S) towards an automatic camera, above the horizontal.
inline const Vec3 kDefaultDirection(0.82, 0.46, 0.34);

// Other names for vectors, plain text; absent: the usual one.
struct VectorNames {
  std::optional<std::string> omega, momentum, torque, gravity, frame_rotation, x, y, z;
};

// What is drawn: the [show] table.
struct ShowSpec {
  // Whether an element (frame/elements.h) is drawn, by its name; absent: Element::by_default
  // decides.
  std::map<std::string, std::optional<bool>> asked;
  std::vector<Vec3> points;   // points drawn as balls with position vectors, in B, m
  double body_opacity = 1.0;  // 0.05..1; below 1: the body is translucent
  bool labels = true;         // show the names of vectors
  bool title = false;         // show the scene's title, at the top
  bool clock = true;          // show the time of the motion, and the time scale if it is not 1
  std::string caption;        // a line at the bottom; empty: none
  double text_size = 1.0;     // scales all text
  // Show step, drifts and error with small numbers in the panels of numerics.compare; absent: no.
  std::optional<bool> details;
  // One panel for each: "space" is seen by the scene's camera, "body" by one that turns with the
  // body.
  std::vector<std::string> views = {"space"};
  std::vector<std::string> plots;  // names from plot_names() (motion/diagram.h)
  std::string material = "plain";  // one of material_names()
  std::string hidden = "dashed";   // one of hidden_names(): vectors and axes behind bodies
  std::optional<VectorNames> names;
  std::vector<Vec3> trail_points;  // points whose paths are drawn, in B, m
  // Vectors whose tips draw their paths: names from traced_vectors(); absent: none.
  std::optional<std::vector<std::string>> trail_tips;
  std::optional<double> vector_length;  // factor on lengths of omega, L and torque; absent: 1
  std::optional<double> trail_s;        // s of motion that paths cover; absent: from the start
  int ghost_count = 5;                  // how many earlier positions of the body are drawn
  std::optional<double> ghost_s;        // s of motion between them; absent: duration / 40

  // Whether the scene asks for the element; absent: it does not say. Adds an absent entry for a
  // name that `asked` lacks.
  std::optional<bool>& operator[](const std::string& name) { return asked[name]; }
};

// The name of an element and its description, for the keys of [show].
struct ShowName {
  std::string name;
  std::string doc;
};
// Both are taken from the table in frame/elements.cpp, in its order.
std::vector<ShowName> show_names();
std::vector<std::string> element_names();

// The colours of the picture.
struct ThemeSpec {
  std::string theme = "dark";             // one of theme_names()
  std::optional<std::string> background;  // "#rrggbb"; absent: that of the theme
};

// How the parts of vectors and axes are drawn that bodies hide: "dashed" or "faint", as if seen
// through the body, or "none".
std::vector<std::string> hidden_names();

// The names of the themes and of the finishes of surfaces (frame/theme.h).
std::vector<std::string> theme_names();
std::vector<std::string> material_names();

template <class Visitor>
void fields(Visitor& v, CameraSpec& s) {
  v.at_most_one_of({"eye", "direction"});
  v.at_most_one_of({"eye", "margin"});
  v.field(
      "eye",
      s.eye,
      Doc{"position of the camera; absent: it frames the whole film automatically", Unit::length});
  v.field(
      "target",
      s.target,
      Doc{"point in the middle of the picture; absent: the middle of what is drawn", Unit::length});
  v.field("fov", s.fov, Doc{"vertical field of view", Unit::angle, Range{0.01, 2.6}});
  v.field("direction",
          s.direction,
          Doc{"direction from the scene towards an automatic camera; absent: [0.82, 0.46, 0.34]"});
  v.field("zoom",
          s.zoom,
          Doc{"factor by which the picture is magnified about its middle",
              Unit::none,
              Range{0.1, 20.0}});
  v.field("margin",
          s.margin,
          Doc{"part of the picture's height that an automatic camera leaves free at each edge, "
              "beside what text needs; absent: 0.045 of width and height",
              Unit::none,
              Range{0.0, 0.4}});
  v.field("orbit",
          s.orbit,
          Doc{"angular velocity of the camera about the vertical through its target, per second of "
              "film",
              Unit::angular_velocity});
  v.field("follow", s.follow, Doc{"what the camera moves with", Unit::none, kAny, follow_names()});
}

template <class Visitor>
void fields(Visitor& v, ShotSpec& s) {
  v.field("name", s.name, Doc{"name of the shot, the title of its chapter"});
  v.required(
      "at", s.at, Doc{"time of the motion at which the shot begins", Unit::time, kNonNegative});
  v.field("move",
          s.move,
          Doc{"film time that the camera takes to move there; 0: a cut", Unit::time, kNonNegative});
  fields(v, s.camera);
}

template <class Visitor>
void fields(Visitor& v, StoryStep& s) {
  v.required(
      "at", s.at, Doc{"time of the motion at which the step begins", Unit::time, kNonNegative});
  v.field("hold",
          s.hold,
          Doc{"how long the motion stands still, in film time", Unit::time, kNonNegative});
  v.field("fade",
          s.fade,
          Doc{"how long elements take to appear and disappear, in film time",
              Unit::time,
              kNonNegative});
  v.field("show", s.show, Doc{"elements that appear now", Unit::none, kAny, element_names()});
  v.field("hide", s.hide, Doc{"elements that disappear now", Unit::none, kAny, element_names()});
  v.field("caption", s.caption, Doc{"caption from now on; empty: none"});
}

// The vectors that ShowSpec::trail_tips may name: "omega", "momentum".
std::vector<std::string> traced_vectors();

template <class Visitor>
void fields(Visitor& v, VectorNames& s) {
  v.field("omega", s.omega, Doc{"of the angular velocity; absent: Ω"});
  v.field("momentum", s.momentum, Doc{"of the angular momentum; absent: L"});
  v.field("torque", s.torque, Doc{"of the torque; absent: τ"});
  v.field("gravity", s.gravity, Doc{"of the weight; absent: mg"});
  v.field(
      "frame_rotation", s.frame_rotation, Doc{"of the axis about which space turns; absent: Ω₀"});
  v.field("x", s.x, Doc{"of the first space axis; absent: X"});
  v.field("y", s.y, Doc{"of the second space axis; absent: Y"});
  v.field("z", s.z, Doc{"of the third space axis; absent: Z"});
}

template <class Visitor>
void fields(Visitor& v, ShowSpec& s) {
  for (const auto& [name, doc] : show_names())
    v.field(name.c_str(), s.asked[name], Doc{doc});
  v.field("body_opacity",
          s.body_opacity,
          Doc{"opacity of the body; below 1 the body is translucent, which excludes cones",
              Unit::none,
              Range{0.05, 1.0}});
  v.field("material",
          s.material,
          Doc{"finish of the body's surface", Unit::none, kAny, material_names()});
  v.field("hidden",
          s.hidden,
          Doc{"how the parts of vectors and axes are drawn that bodies hide",
              Unit::none,
              kAny,
              hidden_names()});
  v.field("vector_length",
          s.vector_length,
          Doc{"factor by which angular velocity, angular momentum and torque are drawn longer; "
              "absent: 1",
              Unit::none,
              Range{0.1, 10.0}});
  v.field("trail_points",
          s.trail_points,
          Doc{"points of the body whose paths are drawn", Unit::length});
  v.field("trail_tips",
          s.trail_tips,
          Doc{"vectors whose tips draw their paths", Unit::none, kAny, traced_vectors()});
  v.field("trail_length",
          s.trail_s,
          Doc{"paths cover this much time before the present; absent: all since the start",
              Unit::time,
              kPositive});
  v.field(
      "ghost_count",
      s.ghost_count,
      Doc{"number of earlier positions of the body that `ghosts` draws", Unit::none, Range{1, 50}});
  v.field("ghost_interval",
          s.ghost_s,
          Doc{"time between the positions that `ghosts` draws; absent: duration / 40",
              Unit::time,
              kPositive});
  v.field(
      "views",
      s.views,
      Doc{"pictures side by side: one seen from space, one from a camera that turns with the body",
          Unit::none,
          kAny,
          {"space", "body"}});
  v.field("plots",
          s.plots,
          Doc{"quantities plotted over time, and diagrams, beside the picture",
              Unit::none,
              kAny,
              plot_names()});
  v.field("labels", s.labels, Doc{"show the names of vectors beside them"});
  v.field("names", s.names, Doc{"other names for vectors"});
  v.field("title", s.title, Doc{"show the scene's title, at the top"});
  v.field("clock",
          s.clock,
          Doc{"show the time of the motion, and how much slower or faster the film runs"});
  v.field("details",
          s.details,
          Doc{"show step, drifts and small errors in the panels of compared methods"});
  v.field("caption", s.caption, Doc{"a caption at the bottom; empty: none"});
  v.field("text_size",
          s.text_size,
          Doc{"factor by which all text is enlarged", Unit::none, Range{0.3, 4.0}});
  v.field("points",
          s.points,
          Doc{"points of the body, drawn with their position vectors", Unit::length});
}

template <class Visitor>
void fields(Visitor& v, ThemeSpec& s) {
  v.field("theme", s.theme, Doc{"colour theme", Unit::none, kAny, theme_names()});
  v.field("background", s.background, Doc{.text = "background colour, \"#rrggbb\"", .color = true});
}

}  // namespace polhode
