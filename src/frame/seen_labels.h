// SPDX-License-Identifier: MIT
// The labels of a moment as a camera sees them, and what they must not cover.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/camera.h"
#include "frame/glyphs.h"
#include "frame/labels.h"
#include "frame/scenery.h"

namespace polhode {

// A circle as a camera sees it, nearly: the ellipse with these half axes; pixels likewise.
struct SeenCircle {
  Vec2 center, half_a, half_b;
};

// A label as a camera sees it. Positions are in pixels from the upper left corner of the camera's
// picture, x to the right, y down.
struct SeenLabel {
  Vec2 from;  // foot of the vector that it names; `at` if it names a point or the foot is not seen
  Vec2 at;
  Vec2 away;                              // unit vector from `at` towards the label
  std::string markup;                     // see text/typesetter.h
  glm::vec3 color;                        // sRGB-encoded, 0..1
  float fade = 1.0f;                      // multiplies the opacity
  bool of_arrow = false;                  // it names an arrow whose tip is `at`
  double size = 1.0;                      // of its type, in that of names of vectors
  std::optional<SeenCircle> circle = {};  // that it names
};

// The labels that a camera sees at one moment, and what they must not cover.
struct LabelView {
  std::vector<SeenLabel> labels;
  std::vector<TextRoom> marks;         // around heads of arrows and marked points, pixels likewise
  std::vector<TextShaft> curves = {};  // pieces of rims of cones and of arcs, pixels likewise
  std::vector<Vec2> body = {};         // its convex outline, likewise, if a circle has a name
};

// The labels of these glyphs that the camera sees, with all but `body`: those of vectors that
// others hide are fainter, or left out. Sizes and colours are those of `scenery`.
LabelView seen_labels(const Glyphs& glyphs, const Camera& camera, const Scenery& scenery);

// The convex outline of points (S, m), nearly: the farthest of them in 24 directions of the
// picture, in turn, pixels. Empty if the camera does not see all of them.
std::vector<Vec2> seen_outline(const std::vector<Vec3>& points_S, const Camera& camera);

}  // namespace polhode
