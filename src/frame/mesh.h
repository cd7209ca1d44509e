// SPDX-License-Identifier: MIT
// Triangle meshes and the pure functions that make them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "math/notation.h"
#include "model/triangle_mesh.h"

namespace polhode {

struct Vertex {
  glm::vec3 position;  // mesh coordinates
  glm::vec3 normal;    // unit, outwards
};

// Triangles, counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  // three per triangle
};
using MeshPtr = std::shared_ptr<const Mesh>;

// How many straight pieces make a circle of this radius in pixels look round: none of it is more
// than a quarter of a pixel from the circle. All round meshes stand halfway: their corners as far
// outside of the true surface as the middles of their pieces lie inside.
int circle_segments(double radius_px);

// The surface that an outline of (radius, z) points sweeps about z, in `segments` steps.
// Neighbouring edges that meet at less than `crease` (rad) are shaded as one smooth surface. The
// outline runs counter-clockwise in the (radius, z) half-plane: upwards on the outside.
inline constexpr double kCreaseAngle = 0.6;  // rad
Mesh revolved(const std::vector<Vec2>& outline, int segments, double crease = kCreaseAngle);

// Unit sphere, its circles of latitude with as many pieces as their size needs; cylinder of radius
// 1 from z = 0 to 1 with caps; cone of base radius 1 at z = 0 with its apex at z = 1 and a base;
// torus about z of radius 1 and the given tube.
Mesh unit_sphere(int segments);
Mesh unit_sphere(int segments, int most_around);  // no more pieces around
Mesh unit_cylinder(int segments);
Mesh unit_cone(int segments);
// The unit disc in the plane z = 0, seen from above.
Mesh unit_disc(int segments);
Mesh torus(double radius, double tube, int segments);
// The open surface r = z for z in 0..1, apex at the origin: half-angle 45 degrees before scaling.
Mesh unit_cone_shell(int segments);
Mesh box(const Vec3& size);

// A surface as it stands: around each corner, faces that meet at less than kCreaseAngle are shaded
// as one smooth surface.
Mesh faceted(const TriangleMesh& surface);

// Every position multiplied component by component, normals kept at right angles.
Mesh scaled(const Mesh& mesh, const Vec3& factors);

}  // namespace polhode
