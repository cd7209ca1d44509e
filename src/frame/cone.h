// SPDX-License-Identifier: MIT
// Circular cones as translucent shells with a rim, in the order that blending needs.
#pragma once

#include <vector>

#include "frame/draw_list.h"
#include "math/notation.h"

namespace polhode {

// An open cone from its apex. half_angle in (0, pi/2) rad; slant: length of a generator, m.
struct Cone {
  Vec3 apex = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  // unit
  double half_angle = 0.5;
  double slant = 1.0;
  double rim_radius = 0.005;  // of the tube drawn along the rim, m
  Material material;          // of the shell; the rim has the same colour, opaque
};

struct ConeMeshes {
  MeshPtr shell;  // unit cone shell
  MeshPtr rim;    // torus of radius 1 and tube kRimTube, scaled into place
};
inline constexpr double kRimTube = 0.01;
ConeMeshes cone_meshes(int segments);

// Adds rims to `opaque` and shells to `translucent`, back to front for this eye. Exact for cones
// with a common apex of which each pair is nested or separated, touching included: nested ones are
// drawn outer back, inner, outer front; separated ones farther first, told by the plane between
// them.
void add_cones(DrawList& list,
               const ConeMeshes& meshes,
               const std::vector<Cone>& cones,
               const Vec3& eye);

}  // namespace polhode
