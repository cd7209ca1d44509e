// SPDX-License-Identifier: MIT
// Glyphs: the geometry of one moment in space S, in metres, between elements (mechanics) and draw
// list (triangles). The automatic camera frames the same glyphs that are drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/arrow.h"
#include "frame/camera.h"
#include "frame/cone.h"
#include "frame/curves.h"
#include "frame/to_glm.h"

namespace polhode {

// An arrow.
struct ArrowGlyph {
  Vec3 from, tip;  // in S, m
  ArrowShape shape;
  Material material;
  bool rim = false;  // has a rim where it lies in a thicker one, see rim_around()
};

// A mesh at its position.
struct MeshGlyph {
  MeshPtr mesh;
  Placement space_from_mesh;  // maps mesh coordinates to S, m
  Material material;
  MeshPtr rough = {};  // roughly the same mesh, which throws its shadow; null: it throws none
  // Of a curve on a translucent ellipsoid: maps the unit ball to that, S, m. Its parts on the side
  // that the eye does not see have the colour of the mark.
  std::optional<Placement> ellipsoid = {};
};

// The part of a path that has been drawn, between two times.
struct PathGlyph {
  const Trail* trail;         // of the scenery, which the glyph must not outlive
  double from, to;            // s of motion
  Placement space_from_path;  // maps the points of the path to S, m
  Material material;
  bool on_body = false;  // the path is in B, else in S
};

// A floor, with the shadows of the meshes that throw one.
struct FloorGlyph {
  Placement place;        // maps the coordinates of frame/shadow.h to S, m
  Material material;      // of floor_mesh()
  Material shadow;        // of shadow_mesh()
  MeshGlyph dial;         // drawn on it; its mesh may be null
  MeshGlyph grid = {};    // lines on it that are made for this moment; its mesh may be null
  MeshGlyph sector = {};  // likewise, that shows how it turns
  double fineness = 1.0;  // of the shadows, see frame/shadow.h
};

// A straight thin tube.
struct RodGlyph {
  Vec3 from, to;  // in S, m
  double radius;  // m
  Material material;
};

// The shorter arc of a circle from one direction to another, as a thin tube.
struct ArcGlyph {
  Vec3 center;         // in S, m
  Vec3 from, to;       // unit vectors from the centre in S, not parallel
  double radius;       // m
  double tube_radius;  // m
  Material material;
};

// A circle in space.
struct CircleGlyph {
  Vec3 center;  // in S, m
  Vec3 half_a;  // from the centre to points of the circle, in S, m,
  Vec3 half_b;  // at right angles
};

// A label beside the point `at`.
struct LabelGlyph {
  Vec3 at;    // in S, m
  Vec3 away;  // the vector that it names, from its foot to `at` (S, m); zero: it names a point and
              // stands above it
  std::string markup;     // see text/typesetter.h
  glm::vec3 color;        // sRGB-encoded, 0..1
  float fade = 1.0f;      // multiplies the opacity
  bool of_arrow = false;  // it names an arrow whose tip is `at`
  double size = 1.0;      // of its type, in that of names of vectors
  // What it names, if that is a circle: in a film it stands wherever there is room around it.
  std::optional<CircleGlyph> circle = {};
  // What it names, if that is another curve: points of it (S, m). In a picture it stands at the one
  // that is farthest up and to the right.
  std::vector<Vec3> curve = {};
};

// A point that labels should not cover.
struct MarkGlyph {
  Vec3 at;        // in S, m
  double radius;  // of what is drawn there, m
};

// A piece of a line that labels should not cover if there is another place.
struct LineGlyph {
  Vec3 from, to;  // in S, m
};

// A flat translucent mesh and the plane that it lies in.
struct SheetGlyph {
  MeshGlyph mesh;
  Vec3 point, normal;  // of the plane, in S: a point (m), and a vector perpendicular to it
  // Of the shadow on it, where the eye and the lamp are above its mesh; absent: it has none. The
  // mesh is then the unit disc of frame/shadow.h.
  std::optional<Material> shadow = {};
};

// All glyphs of one moment.
struct Glyphs {
  std::vector<ArrowGlyph> arrows;
  std::vector<MeshGlyph> meshes;
  std::vector<PathGlyph> paths;
  std::vector<RodGlyph> rods;
  std::vector<ArcGlyph> arcs;
  std::vector<Cone> cones;  // with a common apex
  std::vector<FloorGlyph> floors;
  std::vector<MeshGlyph> ghosts;  // translucent bodies, oldest first
  std::vector<MeshGlyph> shells;  // translucent convex surfaces around all cones, outermost first
  std::vector<SheetGlyph> sheets;
  Vec3 middle = Vec3::Zero();  // the reference point, in S, m
  std::vector<Vec3> reach;     // points (S, m) that show how far the meshes, paths, ghosts, shells
                               // and sheets reach, for framing
  bool for_framing = true;     // false: `reach` may leave out long paths
  std::vector<LabelGlyph> labels;
  std::vector<MarkGlyph> marks;
  std::vector<LineGlyph> lines;  // pieces of curves that are drawn as meshes
};

// How many glyphs there were of each kind when this was made, for fade_new().
struct GlyphCounts {
  explicit GlyphCounts(const Glyphs& glyphs);
  std::size_t arrows, meshes, paths, rods, arcs, cones, floors, ghosts, shells, sheets, labels;
};
// Multiplies the fade of the glyphs that were added since `before` by `presence`: 1 is fully
// visible, 0 invisible.
void fade_new(Glyphs& glyphs, const GlyphCounts& before, double presence);

// For a motion that could not be computed any further: takes away vectors, angles and cones with
// their names. What is left, where things were, becomes pale.
void mark_as_ended(Glyphs& glyphs);

// The point (S, m) at the fraction `part` (0..1) of an arc.
Vec3 point_of(const ArcGlyph& arc, double part);

// Appends points (S, m) whose convex hull contains the glyphs, but for the thickness of tubes and
// arrows, shadows and labels.
void add_extent(const Glyphs& glyphs, std::vector<Vec3>& points);

// The unit meshes that all arrows, rods, arcs and cones share.
struct GlyphMeshes {
  ArrowMeshes arrows;
  ArrowMeshes rough_arrows;  // for their shadows
  ConeMeshes cones;
};

// Adds the glyphs, except their labels, to `list` in the coordinates of `frame`. Translucent items
// are ordered for `eye` (S, m). Shadows fall away from the key light of list.view.
void add_items(const Glyphs& glyphs,
               const GlyphMeshes& meshes,
               const DrawingFrame& frame,
               const Vec3& eye,
               DrawList& list);

}  // namespace polhode
