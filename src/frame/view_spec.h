// SPDX-License-Identifier: MIT
// The [camera] and [show] tables of a scene, and the looks part of [video].
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "math/notation.h"

namespace polhode {

// Where the picture is taken from. Absent eye: the camera frames the whole film by itself.
struct CameraSpec {
  std::optional<Vec3> eye;          // m, space axes
  std::optional<Vec3> target;       // m, space axes; in the middle of the picture
  double fov = 30.0 * kPi / 180.0;  // vertical field of view, rad
  std::optional<Vec3> direction;    // from the scene towards the automatic camera
};

// Where an automatic camera stands when the scene does not say: in front, to the right, above.
inline const Vec3 kDefaultDirection(0.82, 0.46, 0.34);

// What is drawn. Absent: the scene's kind decides (see shown_by_default in frame/compose.h).
struct ShowSpec {
  std::optional<bool> body;
  std::optional<bool> axes;
  std::optional<bool> space_axes;
  std::optional<bool> omega;
  std::optional<bool> momentum;
  std::optional<bool> space_cone;
  std::optional<bool> body_cone;
  std::optional<bool> precession_cone;
  std::optional<bool> pivot;
};

// Colours of the picture.
struct ThemeSpec {
  std::string theme = "dark";             // a name from theme_names()
  std::optional<std::string> background;  // "#rrggbb"
};

std::vector<std::string> theme_names();

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
}

template <class Visitor>
void fields(Visitor& v, ShowSpec& s) {
  v.field("body", s.body, Doc{"the body"});
  v.field("axes", s.axes, Doc{"body axes"});
  v.field("space_axes", s.space_axes, Doc{"space axes"});
  v.field("omega", s.omega, Doc{"angular velocity"});
  v.field("momentum", s.momentum, Doc{"angular momentum"});
  v.field(
      "space_cone", s.space_cone, Doc{"the cone that omega draws in space (symmetric free top)"});
  v.field(
      "body_cone", s.body_cone, Doc{"the cone that omega draws in the body (symmetric free top)"});
  v.field("precession_cone",
          s.precession_cone,
          Doc{"the cone about the vertical through the body axis (pivot)"});
  v.field("pivot", s.pivot, Doc{"the stand under the fixed point"});
}

template <class Visitor>
void fields(Visitor& v, ThemeSpec& s) {
  v.field("theme", s.theme, Doc{"colours", Unit::none, kAny, theme_names()});
  v.field("background", s.background, Doc{.text = "background colour, \"#rrggbb\"", .color = true});
}

}  // namespace polhode
