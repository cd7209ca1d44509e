// SPDX-License-Identifier: MIT
// Draws circular cones as translucent shells with a rim, in the order that blending needs.
#pragma once

#include <map>
#include <vector>

#include "frame/draw_list.h"
#include "frame/to_glm.h"
#include "math/notation.h"

namespace polhode {

// An open cone. Position and lengths are in S (m) in glyphs, and in drawing coordinates
// (DrawingFrame in frame/camera.h) in add_cones().
struct Cone {
  Vec3 apex = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  // unit vector from the apex into the cone
  double half_angle = 0.5;    // rad, in (0, pi/2]; a right angle is a flat disc
  double slant = 1.0;         // from the apex to the rim
  double rim_radius = 0.005;  // of the tube drawn along the rim; a narrow cone has a thinner one
  Material material;          // of the shell; the rim has the same colour, opaque
};

// Where the meshes of a cone stand.
struct ConePlaces {
  Placement shell;    // of unit_cone_shell()
  Placement rim;      // of a torus of radius 1 about z with a tube of radius `tube`
  double tube = 0.0;  // as thick as the cone's own, in its radius
};
// Those of a cone, in the unit of its lengths. A flat one keeps a height that cannot be seen.
ConePlaces cone_places(const Cone& cone);

// The unit meshes that all cones share.
struct ConeMeshes {
  MeshPtr shell;     // unit_cone_shell()
  int segments = 0;  // straight pieces that stand for a rim
  std::map<int, MeshPtr>
      rims;  // that are ready: tori of radius 1, by the step of their tube radius
};
// segments: straight pieces that stand for the rim; shells get seven tenths as many. `expected`:
// cones in any unit whose rims are made ready; add_cones() makes others when it needs them.
ConeMeshes cone_meshes(int segments, const std::vector<Cone>& expected = {});

// Adds rims to list.opaque and shells to list.translucent, back to front for this eye; eye and
// cones are in drawing coordinates. The order is exact for cones with a common apex if each pair is
// nested or separated (they may touch). Nested cones are drawn outer back, inner, outer front; of
// separated cones, the one on the other side of the plane between them is drawn first.
void add_cones(DrawList& list,
               const ConeMeshes& meshes,
               const std::vector<Cone>& cones,
               const Vec3& eye);

}  // namespace polhode
