// SPDX-License-Identifier: MIT
// What a body looks like: meshes in body coordinates, made once.
#pragma once

#include <vector>

#include "frame/draw_list.h"
#include "frame/theme.h"
#include "frame/to_glm.h"
#include "model/body_model.h"

namespace polhode {

// One rigid piece of the body.
struct LookPart {
  MeshPtr mesh;
  Placement body_from_mesh;  // m
  Material material;
};

// The look of a [body] table: its own solids or points; of bare moments the homogeneous ellipsoid
// that has them. segments: pieces of a full circle. Throws Error (input) for an impossible look.
std::vector<LookPart> body_look(const BodySpec& spec,
                                const BodyModel& model,
                                const Theme& theme,
                                int segments);

// The mesh of one solid in its own frame.
Mesh solid_mesh(const SolidSpec& solid, int segments);

// The longest vector of a film, in units of the body's radius.
inline constexpr double kReachOfVectors = 1.5;

// The distance of the farthest drawn body point from the reference point, m.
double body_radius(const std::vector<LookPart>& look, const BodyModel& model);

// Vertices of the look that are farthest in directions all around: for framing, as good as all of
// them to a few ten-thousandths of the body.
std::vector<Vec3> hull_of(const std::vector<LookPart>& look);

// Every vertex of the look, in body coordinates; for framing and scale.
std::vector<Vec3> points_of(const std::vector<LookPart>& look);

}  // namespace polhode
