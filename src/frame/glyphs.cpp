// SPDX-License-Identifier: MIT
#include "frame/glyphs.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr int kPiecesOfRim = 24;  // of a cone, to find how far it reaches
constexpr int kPiecesOfArc = 96;

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

DrawItem item_of(const MeshMark& mark, const DrawingFrame& frame, Faces faces) {
  Placement place = mark.space_from_mesh;
  place.linear() /= frame.unit;
  place.translation() = frame.point(place.translation());
  return {mark.mesh, to_glm(place.matrix()), mark.material, faces};
}

// Translucent surfaces from far to near, as exactly as whole surfaces can be put in order: sheets
// that the eye looks at from the side of the rest, ghosts, the far sides of what surrounds the
// rest, translucent bodies and cones, the near sides, sheets in front.
void add_translucent(const Marks& marks,
                     const MarkMeshes& meshes,
                     const DrawingFrame& frame,
                     const Vec3& eye,
                     DrawList& list) {
  std::vector<DrawItem>& items = list.translucent;
  for (const MeshMark& mark : marks.shades)
    items.push_back(item_of(mark, frame, Faces::front));
  const auto behind = [&](const SheetMark& sheet) {
    // the reference point is where cones begin; sheets through it count as behind
    const double rest = (marks.middle - sheet.point).dot(sheet.normal);
    const double seen = (eye - sheet.point).dot(sheet.normal);
    return rest * seen >= 0.0;
  };
  for (const SheetMark& sheet : marks.sheets) {
    if (behind(sheet)) items.push_back(item_of(sheet.mesh, frame, Faces::both));
  }
  for (const MeshMark& mark : marks.ghosts) {
    items.push_back(item_of(mark, frame, Faces::back));
    items.push_back(item_of(mark, frame, Faces::front));
  }
  for (const MeshMark& mark : marks.shells)
    items.push_back(item_of(mark, frame, Faces::back));

  // far sides of all bodies first: right for convex ones, and nearly so for the rest
  for (const Faces faces : {Faces::back, Faces::front}) {
    for (const MeshMark& mark : marks.meshes) {
      if (mark.material.alpha < 1.0f) items.push_back(item_of(mark, frame, faces));
    }
  }
  std::vector<Cone> cones = marks.cones;
  for (Cone& cone : cones) {
    cone.apex = frame.point(cone.apex);
    cone.slant = frame.length(cone.slant);
    cone.rim_radius = frame.length(cone.rim_radius);
  }
  add_cones(list, meshes.cones, cones, frame.point(eye));
  for (auto mark = marks.shells.rbegin(); mark != marks.shells.rend(); ++mark)
    items.push_back(item_of(*mark, frame, Faces::front));
  for (const SheetMark& sheet : marks.sheets) {
    if (!behind(sheet)) items.push_back(item_of(sheet.mesh, frame, Faces::both));
  }
}

}  // namespace

MarkCounts::MarkCounts(const Marks& marks)
    : arrows(marks.arrows.size()),
      meshes(marks.meshes.size()),
      rods(marks.rods.size()),
      arcs(marks.arcs.size()),
      cones(marks.cones.size()),
      shades(marks.shades.size()),
      ghosts(marks.ghosts.size()),
      shells(marks.shells.size()),
      sheets(marks.sheets.size()),
      labels(marks.labels.size()) {}

void fade_new(Marks& marks, const MarkCounts& before, double presence) {
  const auto fade = static_cast<float>(presence);
  const auto materials = [&](auto& list, std::size_t from) {
    for (std::size_t i = from; i < list.size(); ++i)
      list[i].material.fade *= fade;
  };
  materials(marks.arrows, before.arrows);
  materials(marks.meshes, before.meshes);
  materials(marks.rods, before.rods);
  materials(marks.arcs, before.arcs);
  materials(marks.cones, before.cones);
  materials(marks.shades, before.shades);
  materials(marks.ghosts, before.ghosts);
  materials(marks.shells, before.shells);
  for (std::size_t i = before.sheets; i < marks.sheets.size(); ++i)
    marks.sheets[i].mesh.material.fade *= fade;
  for (std::size_t i = before.labels; i < marks.labels.size(); ++i)
    marks.labels[i].fade *= fade;
}

Vec3 point_of(const ArcMark& arc, double part) {
  const Vec3 across = (arc.to - arc.to.dot(arc.from) * arc.from).normalized();
  const double angle = part * angle_between(arc.from, arc.to);
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
    const Mat3 R = turn_between(Vec3::UnitZ(), cone.axis).toRotationMatrix();
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
    if (mark.material.alpha >= 1.0f) list.opaque.push_back(item_of(mark, frame, Faces::front));
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
  add_translucent(marks, meshes, frame, eye, list);

  // what is coming or going is blended over what is there
  const auto fading =
      std::stable_partition(list.opaque.begin(), list.opaque.end(), [](const DrawItem& item) {
        return item.material.opaque();
      });
  list.translucent.insert(list.translucent.begin(), fading, list.opaque.end());
  list.opaque.erase(fading, list.opaque.end());
}

}  // namespace polhode
