// SPDX-License-Identifier: MIT
// The [body] table of a scene: how mass is distributed, and what is drawn. Positions are in body
// axes B, from the body origin.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "math/notation.h"
#include "model/triangle_mesh.h"

namespace polhode {

// A homogeneous solid and its position in the body. solid_kinds() (model/solids.h) says which
// dimensions a kind takes; the others must stay empty. Exactly one of mass and density is given,
// for BodySpec::look neither.
struct SolidSpec {
  std::string kind;                          // a name from solid_kinds()
  std::optional<double> mass;                // kg
  std::optional<double> density;             // kg/m^3
  std::optional<Vec3> size;                  // box edges along x, y, z, m
  std::optional<Vec3> semi_axes;             // ellipsoid, along x, y, z, m
  std::optional<double> radius;              // m
  std::optional<double> height;              // m, along z
  std::optional<double> length;              // m, along z
  std::optional<double> thickness;           // m, along z
  std::optional<double> tube;                // radius of the tube of a ring, m
  std::optional<std::string> file;           // mesh: an OBJ or STL file, relative to the scene file
  std::optional<double> scale;               // mesh: metres per unit of its file; 1 when absent
  std::shared_ptr<const TriangleMesh> mesh;  // the content of `file`; null until load_meshes()
                                             // (model/solids.h) sets it
  std::vector<Vec2> profile;                 // lathe: (radius, z) points, m, 2 to 2000, or to
                                             // kMostSmooth (model/solids.h) if smooth; empty: not
                                             // given
  bool smooth = false;               // lathe: a curve through them instead of straight lines
  Vec3 at = Vec3::Zero();            // where its own origin is in the body, m
  Vec3 turn = Vec3::Zero();          // turns about the body's x, then y, then z axis, rad
  std::optional<std::string> color;  // "#rrggbb" when drawn; absent: that of the theme
};

// A point mass.
struct PointSpec {
  double m = 0.0;          // kg
  Vec3 at = Vec3::Zero();  // from the body origin, in B, m
};

// The table itself.
struct BodySpec {
  // Exactly one of these five is given: the mass distribution.
  std::optional<Vec3> moments;  // principal moments, body axes = principal axes, kg m^2
  std::optional<Mat3> tensor;   // inertia tensor in body axes, kg m^2
  std::vector<PointSpec> points;
  std::optional<SolidSpec> solid;
  std::vector<SolidSpec> parts;

  std::string about = "center";  // moments or tensor are about: "center" of mass or "pivot"
  bool mathematical = false;     // allow moments that break the triangle inequality
  std::optional<double> mass;    // kg, with moments or tensor; 1 when absent
  // From the body origin, with moments or tensor, in B, m; absent: the body origin.
  std::optional<Vec3> center_of_mass;
  Vec3 pivot = Vec3::Zero();  // the fixed point of a body on a pivot, in B, m
  // What is drawn instead of the mass distribution; absent: that is drawn itself.
  std::optional<SolidSpec> look;
};

// The names in solid_kinds(), for help and the schema.
std::vector<std::string> solid_names();

template <class Visitor>
void fields(Visitor& v, SolidSpec& s) {
  v.required("kind", s.kind, Doc{"shape of the solid", Unit::none, kAny, solid_names()});
  v.field("mass", s.mass, Doc{"mass; this or density", Unit::mass, kPositive});
  v.field("density", s.density, Doc{"density; this or mass", Unit::density, kPositive});
  v.field("size", s.size, Doc{"edges of a box along x, y, z", Unit::length, kPositive});
  v.field("semi_axes", s.semi_axes, Doc{"semi-axes of an ellipsoid", Unit::length, kPositive});
  v.field("radius", s.radius, Doc{"radius", Unit::length, kNonNegative});
  v.field("height", s.height, Doc{"height along z", Unit::length, kPositive});
  v.field("length", s.length, Doc{"length along z", Unit::length, kPositive});
  v.field("thickness", s.thickness, Doc{"thickness along z", Unit::length, kNonNegative});
  v.field("tube", s.tube, Doc{"radius of a ring's tube", Unit::length, kNonNegative});
  v.field("file", s.file, Doc{"mesh: OBJ or STL file, relative to the scene file"});
  v.field("scale", s.scale, Doc{"mesh: metres per unit of its file", Unit::none, kPositive});
  v.field("profile",
          s.profile,
          Doc{"lathe: points (radius, z) of the outline, which is closed through the axis, or is a "
              "tube when the last point repeats the first",
              Unit::length});
  v.field("smooth", s.smooth, Doc{"lathe: a smooth curve through the points of profile"});
  v.field("at", s.at, Doc{"position of the solid's own origin in the body", Unit::length});
  v.field("turn",
          s.turn,
          Doc{"angles by which the solid is turned about the body's x, then y, then z axis",
              Unit::angle});
  v.field("color", s.color, Doc{.text = "colour when drawn, \"#rrggbb\"", .color = true});
}

template <class Visitor>
void fields(Visitor& v, PointSpec& s) {
  v.required("m", s.m, Doc{"mass of the point", Unit::mass, kPositive});
  v.required("at", s.at, Doc{"position of the point, from the body origin", Unit::length});
}

template <class Visitor>
void fields(Visitor& v, BodySpec& s) {
  v.exactly_one_of({"moments", "tensor", "points", "solid", "parts"});
  v.field("moments",
          s.moments,
          Doc{"principal moments; body axes are then principal axes", Unit::inertia, kNonNegative});
  v.field("tensor", s.tensor, Doc{"inertia tensor in body axes, rows", Unit::inertia});
  v.field("points", s.points, Doc{"point masses"});
  v.field("solid", s.solid, Doc{"one homogeneous solid"});
  v.field("parts", s.parts, Doc{"several homogeneous solids that form the body"});
  v.field("about",
          s.about,
          Doc{"the point about which moments or tensor are given",
              Unit::none,
              kAny,
              {"center", "pivot"}});
  v.field("mathematical",
          s.mathematical,
          Doc{"allow principal moments of which one exceeds the sum of the others"});
  v.field("mass", s.mass, Doc{"mass, with moments or tensor; absent: 1 kg", Unit::mass, kPositive});
  v.field("center_of_mass",
          s.center_of_mass,
          Doc{"position of the centre of mass from the body origin, with moments or tensor",
              Unit::length});
  v.field("pivot", s.pivot, Doc{"the fixed point, in body coordinates", Unit::length});
  v.field("look", s.look, Doc{"a solid without mass that is drawn instead of the body"});
}

}  // namespace polhode
