// SPDX-License-Identifier: MIT
// What a picture shows at one moment, as geometry in metres of space: between the elements, which
// know mechanics, and the draw list, which knows triangles. Camera and drawing are made from the
// same glyphs, so what is shown is what is framed.
#pragma once

#include <string>
#include <vector>

#include "frame/arrow.h"
#include "frame/camera.h"
#include "frame/cone.h"
#include "frame/to_glm.h"

namespace polhode {

struct ArrowGlyph {
  Vec3 from, tip;
  ArrowShape shape;
  Material material;
};

struct MeshGlyph {
  MeshPtr mesh;
  Placement space_from_mesh;
  Material material;
};

// A straight thin tube.
struct RodGlyph {
  Vec3 from, to;
  double radius;
  Material material;
};

// The arc of a circle from one direction to another, as a thin tube.
struct ArcGlyph {
  Vec3 center;
  Vec3 from, to;  // unit vectors, not parallel
  double radius;
  double tube_radius;
  Material material;
};

// The name of a thing, beside the point `at`.
struct LabelGlyph {
  Vec3 at;    // space, m
  Vec3 away;  // the vector that it names, from its foot to `at`; zero: none, it stands above
  std::string markup;  // see text/typesetter.h
  glm::vec3 color;
  float fade = 1.0f;
};

// A flat translucent thing and the plane that it lies in.
struct SheetGlyph {
  MeshGlyph mesh;
  Vec3 point, normal;  // space, m
};

struct Glyphs {
  std::vector<ArrowGlyph> arrows;
  std::vector<MeshGlyph> meshes;
  std::vector<RodGlyph> rods;
  std::vector<ArcGlyph> arcs;
  std::vector<Cone> cones;        // with a common apex
  std::vector<MeshGlyph> shades;  // darker places of the floor, lowest first
  std::vector<MeshGlyph> ghosts;  // translucent bodies, oldest first
  std::vector<MeshGlyph> shells;  // translucent convex surfaces around all cones, outermost first
  std::vector<SheetGlyph> sheets;
  Vec3 middle = Vec3::Zero();  // the reference point
  std::vector<Vec3> reach;     // points that the meshes do not go beyond
  std::vector<LabelGlyph> labels;
};

// Lets what was added to glyphs behind these sizes come or go: 1 is there, 0 is not.
struct GlyphCounts {
  explicit GlyphCounts(const Glyphs& glyphs);
  std::size_t arrows, meshes, rods, arcs, cones, shades, ghosts, shells, sheets, labels;
};
void fade_new(Glyphs& glyphs, const GlyphCounts& before, double presence);

// The point at the fraction `part` (0..1) of an arc.
Vec3 point_of(const ArcGlyph& arc, double part);

// Points that together reach as far as the glyphs do.
void add_extent(const Glyphs& glyphs, std::vector<Vec3>& points);

// The meshes that arrows, arcs and cones are drawn with.
struct GlyphMeshes {
  ArrowMeshes arrows;
  ConeMeshes cones;
};

// The items of a draw list in the coordinates of `frame`; `eye` (space, m) orders what is
// translucent.
void add_items(const Glyphs& glyphs,
               const GlyphMeshes& meshes,
               const DrawingFrame& frame,
               const Vec3& eye,
               DrawList& list);

}  // namespace polhode
