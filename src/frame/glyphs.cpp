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
constexpr double kSheetRim = 0.06;  // a sheet does not fade: the shadow ends softly at its rim

ArrowShape drawn(const ArrowShape& shape, const DrawingFrame& frame) {
  return {frame.length(shape.shaft_radius),
          frame.length(shape.head_radius),
          frame.length(shape.head_length)};
}

// Straight tubes, each a little longer than its piece so that no gap opens outside. Where the arc
// is hidden, every second one is a dash.
void add_arc(const ArcGlyph& arc,
             const ArrowMeshes& meshes,
             const DrawingFrame& frame,
             DrawList& list) {
  const double radius = frame.length(arc.tube_radius);
  for (int i = 0; i < kPiecesOfArc; ++i) {
    const Vec3 from = frame.point(point_of(arc, static_cast<double>(i) / kPiecesOfArc));
    const Vec3 to = frame.point(point_of(arc, static_cast<double>(i + 1) / kPiecesOfArc));
    const Vec3 overlap = 0.3 * radius * (to - from).normalized();
    Material material = arc.material;
    if (material.dashes > 0.0f && i % 2 == 1) material.hidden = 0.0f;
    material.dashes = 0.0f;
    add_tube(list.opaque, meshes, from - overlap, to + overlap, radius, material);
  }
}

// around the thickest arrow that hides this one
void add_rim(const ArrowGlyph& arrow,
             const std::vector<ArrowGlyph>& arrows,
             const ArrowMeshes& meshes,
             const DrawingFrame& frame,
             DrawList& list) {
  const Vec3 vector = arrow.tip - arrow.from;
  std::optional<ArrowRim> widest;
  Material material = arrow.material;
  for (const ArrowGlyph& other : arrows) {
    if (other.from != arrow.from) continue;
    const auto rim = rim_around(vector, arrow.shape, other.tip - other.from, other.shape);
    if (!rim || (widest && widest->radius >= rim->radius)) continue;
    widest = rim;
    // it is gone with either of them
    material.fade = arrow.material.fade * other.material.fade;
  }
  if (!widest) return;
  const Vec3 end = arrow.from + vector * (widest->length / vector.norm());
  add_tube(list.opaque,
           meshes,
           frame.point(arrow.from),
           frame.point(end),
           frame.length(widest->radius),
           material,
           Faces::back);
}

glm::mat4 drawn(Placement place, const DrawingFrame& frame) {
  place.linear() /= frame.unit;
  place.translation() = frame.point(place.translation());
  return to_glm(place.matrix());
}

DrawItem item_of(const MeshGlyph& glyph, const DrawingFrame& frame, Faces faces) {
  return {glyph.mesh, drawn(glyph.space_from_mesh, frame), glyph.material, faces};
}

void add_path(const PathGlyph& path, const DrawingFrame& frame, DrawList& list) {
  const Placement place = path.space_from_path * path.trail->place();
  for (const MeshPtr& mesh : path.trail->part(path.from, path.to))
    list.opaque.push_back(item_of({mesh, place, path.material}, frame, Faces::front));
}

// Which side of a curve the eye sees: that of the polar plane of the eye with the ellipsoid, which
// holds the points where lines of sight touch it.
glm::vec4 near_side(const MeshGlyph& curve, const Vec3& eye) {
  const Placement ball_from_space = curve.ellipsoid->inverse();
  const Placement ball_from_mesh = ball_from_space * curve.space_from_mesh;
  const Vec3 seen_from = ball_from_space * eye;
  const Vec3 along = ball_from_mesh.linear().transpose() * seen_from;
  const double offset = ball_from_mesh.translation().dot(seen_from) - 1.0;
  const double size = along.norm();
  return {to_glm(Vec3(along / size)), static_cast<float>(offset / size)};
}

// what throws shadows, in the coordinates of a floor: bodies and shells
std::vector<ShadowCaster> broad_casters(const Glyphs& glyphs, const Placement& floor_from_space) {
  std::vector<ShadowCaster> casters;
  const auto add = [&](const MeshGlyph& glyph, float density) {
    if (glyph.rough == nullptr) return;
    casters.push_back({glyph.rough, floor_from_space * glyph.space_from_mesh, density});
  };
  for (const MeshGlyph& glyph : glyphs.meshes)
    add(glyph, std::min(glyph.material.alpha, 1.0f) * glyph.material.fade);
  // light goes through two of its walls
  for (const MeshGlyph& glyph : glyphs.shells) {
    const float through = 1.0f - glyph.material.alpha * glyph.material.fade;
    add(glyph, 1.0f - through * through);
  }
  return casters;
}

// and arrows, which hide no sky
void add_thin_casters(const Glyphs& glyphs,
                      const GlyphMeshes& meshes,
                      const Placement& floor_from_space,
                      std::vector<ShadowCaster>& casters) {
  for (const ArrowGlyph& arrow : glyphs.arrows) {
    const std::optional<ArrowPlaces> places = arrow_places(arrow.from, arrow.tip, arrow.shape);
    if (!places) continue;
    casters.push_back(
        {meshes.rough_arrows.shaft, floor_from_space * places->shaft, arrow.material.fade});
    casters.push_back(
        {meshes.rough_arrows.head, floor_from_space * places->head, arrow.material.fade});
  }
}

// a sheet, and the shadow on it if the lamp is above
void add_sheet(const SheetGlyph& sheet,
               const Glyphs& glyphs,
               const GlyphMeshes& meshes,
               const DrawingFrame& frame,
               DrawList& list) {
  list.translucent.push_back(item_of(sheet.mesh, frame, Faces::both));
  if (!sheet.shadow) return;
  const Placement& place = sheet.mesh.space_from_mesh;
  const Placement sheet_from_space = place.inverse();
  const Vec3 to_light = sheet_from_space.linear() * to_eigen(list.view.key_light);
  if (to_light.z() <= 0.0) return;
  std::vector<ShadowCaster> casters = broad_casters(glyphs, sheet_from_space);
  add_thin_casters(glyphs, meshes, sheet_from_space, casters);
  const MeshPtr shadow = shadow_mesh(casters, to_light, 1.0, kSheetRim);
  if (shadow != nullptr)
    list.translucent.push_back(item_of({shadow, place, *sheet.shadow}, frame, Faces::front));
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
    std::vector<ShadowCaster> casters = broad_casters(glyphs, floor_from_space);
    // thin lines hide no sky
    add_layer(floor_mesh(casters, floor.fineness), floor.material);
    for (const MeshGlyph* lines : {&floor.sector, &floor.dial, &floor.grid}) {
      if (lines->mesh != nullptr) list.translucent.push_back(item_of(*lines, frame, Faces::front));
    }
    add_thin_casters(glyphs, meshes, floor_from_space, casters);
    const Vec3 to_light = floor_from_space.linear() * to_eigen(list.view.key_light);
    add_layer(shadow_mesh(casters, to_light, floor.fineness), floor.shadow);
  }
}

// what is coming or going is blended over what is there
void move_fading(DrawList& list) {
  const auto fading =
      std::stable_partition(list.opaque.begin(), list.opaque.end(), [](const DrawItem& item) {
        return item.material.opaque();
      });
  list.translucent.insert(list.translucent.end(), fading, list.opaque.end());
  list.opaque.erase(fading, list.opaque.end());
}

// Translucent surfaces from far to near, as exactly as whole surfaces can be put in order: floors
// and sheets that the eye looks at from the side of the rest, what fades, ghosts, the far sides of
// what surrounds the rest, translucent bodies and cones, the near sides, sheets in front.
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
    if (behind(sheet)) add_sheet(sheet, glyphs, meshes, frame, list);
  }
  move_fading(list);
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
      paths(glyphs.paths.size()),
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
  materials(glyphs.paths, before.paths);
  materials(glyphs.rods, before.rods);
  materials(glyphs.arcs, before.arcs);
  materials(glyphs.cones, before.cones);
  materials(glyphs.ghosts, before.ghosts);
  materials(glyphs.shells, before.shells);
  for (std::size_t i = before.sheets; i < glyphs.sheets.size(); ++i) {
    SheetGlyph& sheet = glyphs.sheets[i];
    sheet.mesh.material.fade *= fade;
    if (sheet.shadow) sheet.shadow->fade *= fade;
  }
  for (std::size_t i = before.floors; i < glyphs.floors.size(); ++i) {
    FloorGlyph& floor = glyphs.floors[i];
    for (Material* material : {&floor.material,
                               &floor.shadow,
                               &floor.dial.material,
                               &floor.grid.material,
                               &floor.sector.material})
      material->fade *= fade;
  }
  for (std::size_t i = before.labels; i < glyphs.labels.size(); ++i)
    glyphs.labels[i].fade *= fade;
}

void mark_as_ended(Glyphs& glyphs) {
  constexpr float kPale = 0.35f;
  glyphs.arrows.clear();
  glyphs.arcs.clear();
  glyphs.cones.clear();
  glyphs.labels.clear();
  for (MeshGlyph& mesh : glyphs.meshes)
    mesh.material.fade *= kPale;
  for (PathGlyph& path : glyphs.paths)
    path.material.fade *= kPale;
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
    if (glyph.material.alpha < 1.0f) continue;
    list.opaque.push_back(item_of(glyph, frame, Faces::front));
    if (glyph.ellipsoid) list.opaque.back().material.near_side = near_side(glyph, eye);
  }
  for (const PathGlyph& path : glyphs.paths)
    add_path(path, frame, list);
  // before what they surround, which is blended over them if it is coming or going
  for (const ArrowGlyph& arrow : glyphs.arrows) {
    if (arrow.rim) add_rim(arrow, glyphs.arrows, meshes.arrows, frame, list);
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
}

}  // namespace polhode
