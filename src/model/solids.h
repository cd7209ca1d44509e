// SPDX-License-Identifier: MIT
// The table of homogeneous solids: which dimensions each takes, and its mass properties.
#pragma once

#include <string>
#include <vector>

#include "model/body_spec.h"
#include "model/mass_properties.h"

namespace polhode {

// One row per solid. To add a solid: a row here and a mesh in frame/body_look.cpp.
struct SolidKind {
  std::string name;
  std::string doc;                     // shape, origin and axis, one phrase
  std::vector<std::string> needs;      // keys of SolidSpec that must be given
  std::vector<std::string> takes;      // keys of SolidSpec that may be given
  double (*volume)(const SolidSpec&);  // m^3; 0 for a thin solid, which then needs a mass
  // Per kilogram, about its own centre of mass: .mass is 1, .center in the solid's own frame (m),
  // .tensor in m^2.
  MassProperties (*per_mass)(const SolidSpec&);
};

// The table of all solids; it exists until the program ends.
const std::vector<SolidKind>& solid_kinds();

// Throws Error (input) naming `path`.KEY for an unknown kind, for a dimension that does not belong
// to the kind or is impossible (for example a lathe outline that crosses itself), and for a mesh
// that has not been loaded; naming `path` if a dimension is missing.
void check_dimensions(const SolidSpec& solid, const std::string& path);

// Reads and checks the mesh files of all mesh solids of a body, also of its look, and stores them
// in SolidSpec::mesh; `file` is relative to `folder`. Throws Error (input) naming the key of the
// file, such as body.solid.file, as load_solid_mesh (model/triangle_mesh.h) does.
void load_meshes(BodySpec& body, const std::filesystem::path& folder);

// Mass properties in the body frame: the solid turned by `turn` and moved by `at`. Throws Error
// (input) as check_dimensions does, naming `path` unless exactly one of mass and density is given,
// and naming `path`.density for the density of a thin solid.
MassProperties mass_properties(const SolidSpec& solid, const std::string& path);

// The outline of a lathe solid as (radius, z) points, m: its profile or, if it is smooth and has at
// least three points, a centripetal Catmull-Rom curve through it (Barry and Goldman, SIGGRAPH 1988;
// Yuksel and others, Computer-Aided Design 43 (2011) 747) in straight pieces. Mass properties and
// the drawn mesh use the same outline.
std::vector<Vec2> lathe_outline(const SolidSpec& solid);
// The greatest number of points of a smooth profile.
inline constexpr std::size_t kMostSmooth = 200;

}  // namespace polhode
