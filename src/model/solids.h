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
  std::vector<std::string> needs;      // dimensions that must be given
  std::vector<std::string> takes;      // dimensions that may be given
  double (*volume)(const SolidSpec&);  // m^3; 0 for a thin solid, which then needs a mass
  // Per kilogram, about its own centre: .mass is 1, .center in the solid's own frame (m),
  // .tensor in m^2.
  MassProperties (*per_mass)(const SolidSpec&);
};

const std::vector<SolidKind>& solid_kinds();

// Throws Error (input) with key `path`.NAME when a dimension is missing, does not belong to the
// kind, or is impossible (a lathe outline that crosses itself, say).
void check_dimensions(const SolidSpec& solid, const std::string& path);

// Reads the files of all mesh solids of a body, `file` relative to `folder`, and checks them.
// Throws Error (input) with key `path`.file: what load_solid_mesh refuses.
void load_meshes(BodySpec& body, const std::filesystem::path& folder);

// Mass properties in the body frame: the solid turned by `turn` and moved by `at`. Throws Error
// (input) as check_dimensions does, and when not exactly one of mass and density is given.
MassProperties mass_properties(const SolidSpec& solid, const std::string& path);

// The outline that a lathe's solid has: its profile, or if it is smooth a centripetal Catmull-Rom
// curve through it (Barry and Goldman, SIGGRAPH 1988; Yuksel and others, Computer-Aided Design 43
// (2011) 747) in straight pieces. Mass and picture are made of the same.
std::vector<Vec2> lathe_outline(const SolidSpec& solid);
inline constexpr std::size_t kMostSmooth = 200;

}  // namespace polhode
