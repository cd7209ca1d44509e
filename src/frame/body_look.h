// SPDX-License-Identifier: MIT
// Makes the meshes of a body, placed in body axes B.
#pragma once

#include <vector>

#include "frame/draw_list.h"
#include "frame/theme.h"
#include "frame/to_glm.h"
#include "model/body_model.h"

namespace polhode {

// One mesh of the body with one material.
struct LookPart {
  MeshPtr mesh;
  Placement body_from_mesh;  // maps mesh coordinates to B, m
  Material material;
  MeshPtr rough = {};    // roughly the same mesh, for its shadow
  double breadth = 0.0;  // of its box in mesh coordinates, the middle one of the three sides, m
};

// The meshes of a [body] table: its look if there is one, else its solids or points, else (moments
// or a tensor) the homogeneous ellipsoid that has them. Thin discs, rings, rods and that ellipsoid
// get a thickness that can be seen. `model` is that of `spec`, whose meshes must be loaded
// (load_meshes() in model/solids.h). segments: straight pieces that stand for a full circle as
// large as the body. Throws Error (input) naming body.look or a key in it for a look that is
// impossible or has a mass.
std::vector<LookPart> body_look(const BodySpec& spec,
                                const BodyModel& model,
                                const Theme& theme,
                                int segments);

// The mesh of one solid in its own frame, m, without SolidSpec::at and turn. The dimensions must
// have passed check_dimensions() (model/solids.h), and the mesh of a mesh solid must be loaded.
// segments: straight pieces that stand for a full circle as large as the solid.
Mesh solid_mesh(const SolidSpec& solid, int segments);

// The drawn length of the longest angular momentum of a film, in units of Scale::body
// (frame/scenery.h); no other vector is drawn longer by its scale.
inline constexpr double kReachOfVectors = 1.5;

// The distance of the farthest vertex of the body from the reference point
// (BodyModel::reference_B()), m.
double body_radius(const std::vector<LookPart>& look, const BodyModel& model);

// The vertices (B, m) that lie farthest along each of 500 directions, spread evenly over the
// sphere: one per direction, with repeats. For framing they replace all vertices, with an error of
// a few thousandths of the body's size.
std::vector<Vec3> hull_of(const std::vector<LookPart>& look);

// All vertices (B, m), for framing and scale.
std::vector<Vec3> points_of(const std::vector<LookPart>& look);

}  // namespace polhode
