// SPDX-License-Identifier: MIT
#include "frame/marks.h"

#include <cmath>

#include "base/units.h"

namespace polhode {
namespace {

constexpr int kPiecesOfRim = 24;  // of a cone, to find how far it reaches
constexpr int kPiecesOfArc = 32;

ArrowShape drawn(const ArrowShape& shape, const DrawingFrame& frame) {
  return {frame.length(shape.shaft_radius),
          frame.length(shape.head_radius),
          frame.length(shape.head_length)};
}

// straight tubes, each a little longer than its piece so that no gap opens outside
void add_arc(const ArcMark& arc,
             const ArrowMeshes& meshes,
             const DrawingFrame& frame,
             DrawList& list) {
  const double radius = frame.length(arc.tube_radius);
  for (int i = 0; i < kPiecesOfArc; ++i) {
    const Vec3 from = frame.point(point_of(arc, static_cast<double>(i) / kPiecesOfArc));
    const Vec3 to = frame.point(point_of(arc, static_cast<double>(i + 1) / kPiecesOfArc));
    const Vec3 overlap = 0.3 * radius * (to - from).normalized();
    add_tube(list.opaque, meshes, from - overlap, to + overlap, radius, arc.material);
  }
}

}  // namespace

Vec3 point_of(const ArcMark& arc, double part) {
  const Vec3 across = (arc.to - arc.to.dot(arc.from) * arc.from).normalized();
  const double angle = part * std::atan2(arc.from.cross(arc.to).norm(), arc.from.dot(arc.to));
  return arc.center + arc.radius * (std::cos(angle) * arc.from + std::sin(angle) * across);
}

void add_extent(const Marks& marks, std::vector<Vec3>& points) {
  for (const ArrowMark& arrow : marks.arrows) {
    points.push_back(arrow.from);
    points.push_back(arrow.tip);
  }
  for (const RodMark& rod : marks.rods) {
    points.push_back(rod.from);
    points.push_back(rod.to);
  }
  points.insert(points.end(), marks.reach.begin(), marks.reach.end());
  for (const ArcMark& arc : marks.arcs) {
    for (int i = 0; i <= kPiecesOfArc; ++i)
      points.push_back(point_of(arc, static_cast<double>(i) / kPiecesOfArc));
  }
  for (const Cone& cone : marks.cones) {
    const Mat3 R = Quat::FromTwoVectors(Vec3::UnitZ(), cone.axis).toRotationMatrix();
    points.push_back(cone.apex);
    for (int k = 0; k < kPiecesOfRim; ++k) {
      const double angle = 2.0 * kPi * k / kPiecesOfRim;
      const double across = std::sin(cone.half_angle);
      points.push_back(cone.apex + cone.slant * (R * Vec3(across * std::cos(angle),
                                                          across * std::sin(angle),
                                                          std::cos(cone.half_angle))));
    }
  }
}

void add_items(const Marks& marks,
               const MarkMeshes& meshes,
               const DrawingFrame& frame,
               const Vec3& eye,
               DrawList& list) {
  for (const MeshMark& mark : marks.meshes) {
    Placement place = mark.space_from_mesh;
    place.linear() /= frame.unit;
    place.translation() = frame.point(place.translation());
    const glm::mat4 world_from_mesh = to_glm(place.matrix());
    if (mark.material.alpha >= 1.0f) {
      list.opaque.push_back({mark.mesh, world_from_mesh, mark.material, Faces::front});
      continue;
    }
    // far sides of all of them first: right for convex bodies, and nearly so for the rest
    const auto near_sides =
        list.translucent.begin() + static_cast<std::ptrdiff_t>(list.translucent.size() / 2);
    list.translucent.insert(near_sides, {mark.mesh, world_from_mesh, mark.material, Faces::back});
    list.translucent.push_back({mark.mesh, world_from_mesh, mark.material, Faces::front});
  }
  for (const ArrowMark& arrow : marks.arrows) {
    add_arrow(list.opaque,
              meshes.arrows,
              frame.point(arrow.from),
              frame.point(arrow.tip),
              drawn(arrow.shape, frame),
              arrow.material);
  }
  for (const RodMark& rod : marks.rods) {
    add_tube(list.opaque,
             meshes.arrows,
             frame.point(rod.from),
             frame.point(rod.to),
             frame.length(rod.radius),
             rod.material);
  }
  for (const ArcMark& arc : marks.arcs)
    add_arc(arc, meshes.arrows, frame, list);
  std::vector<Cone> cones = marks.cones;
  for (Cone& cone : cones) {
    cone.apex = frame.point(cone.apex);
    cone.slant = frame.length(cone.slant);
    cone.rim_radius = frame.length(cone.rim_radius);
  }
  add_cones(list, meshes.cones, cones, frame.point(eye));
}

}  // namespace polhode
