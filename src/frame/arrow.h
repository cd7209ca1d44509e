// SPDX-License-Identifier: MIT
// Draws vectors as arrows. The tip is exactly at the end of the vector. Positions and lengths are
// in S (m) in glyphs, and in drawing coordinates (DrawingFrame in frame/camera.h) in add_arrow()
// and add_tube().
#pragma once

#include <optional>
#include <vector>

#include "frame/draw_list.h"
#include "frame/to_glm.h"
#include "math/notation.h"

namespace polhode {

// The unit meshes that all arrows share.
struct ArrowMeshes {
  MeshPtr shaft;  // unit_cylinder()
  MeshPtr head;   // unit_cone()
};
// The arguments are the numbers of straight pieces that stand for a full circle.
ArrowMeshes arrow_meshes(int around_shaft, int around_head);

// The sizes of an arrow, in the unit of its positions (in frame/elements/parts.h in radii of the
// body). If the head is longer than two thirds of the vector, all sizes shrink until it is not.
struct ArrowShape {
  double shaft_radius = 0.01;
  double head_radius = 0.03;
  double head_length = 0.09;
};

// Hidden parts of shafts and tubes are dashed where material.dashes is not 0, whatever its value.
// What a dash and a gap take, from the foot on, in the unit of drawing: the body's radius.
inline constexpr double kDashLength = 0.09;

// The sizes with which an arrow of that length is drawn.
ArrowShape fitting(const ArrowShape& shape, double length);

// Where the unit meshes of an arrow stand.
struct ArrowPlaces {
  Placement shaft, head;
};
// Those of the arrow from `from` to `tip`, in any unit; none if it is shorter than a thousandth of
// the head's length.
std::optional<ArrowPlaces> arrow_places(const Vec3& from, const Vec3& tip, const ArrowShape& shape);

// Adds the items of the arrow from `from` to `tip` to `items`; nothing if it is shorter than a
// thousandth of the head's length.
void add_arrow(std::vector<DrawItem>& items,
               const ArrowMeshes& meshes,
               const Vec3& from,
               const Vec3& tip,
               const ArrowShape& shape,
               const Material& material);

// A tube that surrounds a vector.
struct ArrowRim {
  double radius, length;
};
// Where the shaft of one arrow is hidden in the thicker shaft of another from the same foot, a rim
// around that shows it: the far side of a tube around its own axis, from the foot on, drawn without
// its near side. It narrows to the shaft as the arrows part; none if they are apart, if the other
// is not thicker, or if one of them is too short to be drawn. In the unit of the arguments.
std::optional<ArrowRim> rim_around(const Vec3& vector,
                                   const ArrowShape& shape,
                                   const Vec3& thicker,
                                   const ArrowShape& thicker_shape);

// Adds a tube with flat ends; nothing if its length is zero.
void add_tube(std::vector<DrawItem>& items,
              const ArrowMeshes& meshes,
              const Vec3& from,
              const Vec3& to,
              double radius,
              const Material& material,
              Faces faces = Faces::front);

}  // namespace polhode
