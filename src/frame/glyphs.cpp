// SPDX-License-Identifier: MIT
#include "frame/glyphs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/units.h"
#include "frame/shadow.h"
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
void add_arc(const ArcGlyph& arc,
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

glm::mat4 drawn(Placement place, const DrawingFrame& frame) {
  place.linear() /= frame.unit;
  place.translation() = frame.point(place.translation());
  return to_glm(place.matrix());
}

DrawItem item_of(const MeshGlyph& glyph, const DrawingFrame& frame, Faces faces) {
  return {glyph.mesh, drawn(glyph.space_from_mesh, frame), glyph.material, faces};
}

// floors, and on them the shadows that fall away from the light of the list
void add_floors(const Glyphs& glyphs,
                const GlyphMeshes& meshes,
                const DrawingFrame& frame,
                DrawList& list) {
  for (const FloorGlyph& floor : glyphs.floors) {
    const Placement floor_from_space = floor.place.inverse();
    const auto add_layer = [&](const MeshPtr& mesh, const Material& material) {
      if (mesh == nullptr) return;
      list.translucent.push_back(item_of({mesh, floor.place, material}, frame, Faces::front));
    };
    std::vector<ShadowCaster> casters;
    for (const MeshGlyph& glyph : glyphs.meshes) {
      if (glyph.rough == nullptr) continue;
      const float density = std::min(glyph.material.alpha, 1.0f) * glyph.material.fade;
      casters.push_back({glyph.rough, floor_from_space * glyph.space_from_mesh, density});
    }
    // thin lines hide no sky
    add_layer(floor_mesh(casters, floor.fineness), floor.material);
    for (const MeshGlyph* lines : {&floor.dial, &floor.grid}) {
      if (lines->mesh != nullptr) list.translucent.push_back(item_of(*lines, frame, Faces::front));
    }
    for (const ArrowGlyph& arrow : glyphs.arrows) {
      const std::optional<ArrowPlaces> places = arrow_places(arrow.from, arrow.tip, arrow.shape);
      if (!places) continue;
      casters.push_back(
          {meshes.rough_arrows.shaft, floor_from_space * places->shaft, arrow.material.fade});
      casters.push_back(
          {meshes.rough_arrows.head, floor_from_space * places->head, arrow.material.fade});
    }
    const Vec3 to_light = floor_from_space.linear() * to_eigen(list.view.key_light);
    add_layer(shadow_mesh(casters, to_light, floor.fineness), floor.shadow);
  }
}

// Translucent surfaces from far to near, as exactly as whole surfaces can be put in order: sheets
// that the eye looks at from the side of the rest, ghosts, the far sides of what surrounds the
// rest, translucent bodies and cones, the near sides, sheets in front.
void add_translucent(const Glyphs& glyphs,
                     const GlyphMeshes& meshes,
                     const DrawingFrame& frame,
                     const Vec3& eye,
                     DrawList& list) {
  std::vector<DrawItem>& items = list.translucent;
  add_floors(glyphs, meshes, frame, list);
  const auto behind = [&](const SheetGlyph& sheet) {
    // the reference point is where cones begin; sheets through it count as behind
    const double rest = (glyphs.middle - sheet.point).dot(sheet.normal);
    const double seen = (eye - sheet.point).dot(sheet.normal);
    return rest * seen >= 0.0;
  };
  for (const SheetGlyph& sheet : glyphs.sheets) {
    if (behind(sheet)) items.push_back(item_of(sheet.mesh, frame, Faces::both));
  }
  for (const MeshGlyph& glyph : glyphs.ghosts) {
    items.push_back(item_of(glyph, frame, Faces::back));
    items.push_back(item_of(glyph, frame, Faces::front));
  }
  for (const MeshGlyph& glyph : glyphs.shells)
    items.push_back(item_of(glyph, frame, Faces::back));

  // far sides of all bodies first: right for convex ones, and nearly so for the rest
  for (const Faces faces : {Faces::back, Faces::front}) {
    for (const MeshGlyph& glyph : glyphs.meshes) {
      if (glyph.material.alpha < 1.0f) items.push_back(item_of(glyph, frame, faces));
    }
  }
  std::vector<Cone> cones = glyphs.cones;
  for (Cone& cone : cones) {
    cone.apex = frame.point(cone.apex);
    cone.slant = frame.length(cone.slant);
    cone.rim_radius = frame.length(cone.rim_radius);
  }
  add_cones(list, meshes.cones, cones, frame.point(eye));
  for (auto glyph = glyphs.shells.rbegin(); glyph != glyphs.shells.rend(); ++glyph)
    items.push_back(item_of(*glyph, frame, Faces::front));
  for (const SheetGlyph& sheet : glyphs.sheets) {
    if (!behind(sheet)) items.push_back(item_of(sheet.mesh, frame, Faces::both));
  }
}

}  // namespace

GlyphCounts::GlyphCounts(const Glyphs& glyphs)
    : arrows(glyphs.arrows.size()),
      meshes(glyphs.meshes.size()),
      rods(glyphs.rods.size()),
      arcs(glyphs.arcs.size()),
      cones(glyphs.cones.size()),
      floors(glyphs.floors.size()),
      ghosts(glyphs.ghosts.size()),
      shells(glyphs.shells.size()),
      sheets(glyphs.sheets.size()),
      labels(glyphs.labels.size()) {}

void fade_new(Glyphs& glyphs, const GlyphCounts& before, double presence) {
  const auto fade = static_cast<float>(presence);
  const auto materials = [&](auto& list, std::size_t from) {
    for (std::size_t i = from; i < list.size(); ++i)
      list[i].material.fade *= fade;
  };
  materials(glyphs.arrows, before.arrows);
  materials(glyphs.meshes, before.meshes);
  materials(glyphs.rods, before.rods);
  materials(glyphs.arcs, before.arcs);
  materials(glyphs.cones, before.cones);
  materials(glyphs.ghosts, before.ghosts);
  materials(glyphs.shells, before.shells);
  for (std::size_t i = before.sheets; i < glyphs.sheets.size(); ++i)
    glyphs.sheets[i].mesh.material.fade *= fade;
  for (std::size_t i = before.floors; i < glyphs.floors.size(); ++i) {
    FloorGlyph& floor = glyphs.floors[i];
    for (Material* material :
         {&floor.material, &floor.shadow, &floor.dial.material, &floor.grid.material})
      material->fade *= fade;
  }
  for (std::size_t i = before.labels; i < glyphs.labels.size(); ++i)
    glyphs.labels[i].fade *= fade;
}

Vec3 point_of(const ArcGlyph& arc, double part) {
  const Vec3 across = (arc.to - arc.to.dot(arc.from) * arc.from).normalized();
  const double angle = part * angle_between(arc.from, arc.to);
  return arc.center + arc.radius * (std::cos(angle) * arc.from + std::sin(angle) * across);
}

void add_extent(const Glyphs& glyphs, std::vector<Vec3>& points) {
  for (const ArrowGlyph& arrow : glyphs.arrows) {
    points.push_back(arrow.from);
    points.push_back(arrow.tip);
  }
  points.insert(points.end(), glyphs.reach.begin(), glyphs.reach.end());
  for (const RodGlyph& rod : glyphs.rods) {
    points.push_back(rod.from);
    points.push_back(rod.to);
  }
  for (const ArcGlyph& arc : glyphs.arcs) {
    for (int i = 0; i <= kPiecesOfArc; ++i)
      points.push_back(point_of(arc, static_cast<double>(i) / kPiecesOfArc));
  }
  for (const Cone& cone : glyphs.cones) {
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

void add_items(const Glyphs& glyphs,
               const GlyphMeshes& meshes,
               const DrawingFrame& frame,
               const Vec3& eye,
               DrawList& list) {
  for (const MeshGlyph& glyph : glyphs.meshes) {
    if (glyph.material.alpha >= 1.0f) list.opaque.push_back(item_of(glyph, frame, Faces::front));
  }
  for (const ArrowGlyph& arrow : glyphs.arrows) {
    add_arrow(list.opaque,
              meshes.arrows,
              frame.point(arrow.from),
              frame.point(arrow.tip),
              drawn(arrow.shape, frame),
              arrow.material);
  }
  for (const RodGlyph& rod : glyphs.rods) {
    add_tube(list.opaque,
             meshes.arrows,
             frame.point(rod.from),
             frame.point(rod.to),
             frame.length(rod.radius),
             rod.material);
  }
  for (const ArcGlyph& arc : glyphs.arcs)
    add_arc(arc, meshes.arrows, frame, list);
  add_translucent(glyphs, meshes, frame, eye, list);

  // what is coming or going is blended over what is there
  const auto fading =
      std::stable_partition(list.opaque.begin(), list.opaque.end(), [](const DrawItem& item) {
        return item.material.opaque();
      });
  list.translucent.insert(list.translucent.begin(), fading, list.opaque.end());
  list.opaque.erase(fading, list.opaque.end());
}

}  // namespace polhode
