// SPDX-License-Identifier: MIT
// Triangle meshes for drawing, and the pure functions that make them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "math/notation.h"
#include "model/triangle_mesh.h"

namespace polhode {

// A corner of a triangle.
struct Vertex {
  glm::vec3 position;  // mesh coordinates
  glm::vec3 normal;    // unit, outwards; of a shadow: see frame/shadow.h
};

// Triangles, counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  // three per triangle
};
using MeshPtr = std::shared_ptr<const Mesh>;

// The number of straight pieces that approximate a circle of this radius (pixels) to a quarter of a
// pixel, at least eight. In all round meshes the corners lie as far outside the true surface as the
// middles of the pieces lie inside. `segments` below is the number of pieces of a full circle.
int circle_segments(double radius_px);

// Faces whose normals differ by less than this are shaded as one smooth surface.
inline constexpr double kCreaseAngle = 0.6;  // rad
// The surface of revolution of an outline of (radius, z) points about z, in `segments` steps. The
// outline runs counter-clockwise in the (radius, z) half-plane: upwards on the outside. It is not
// closed: ends off the axis leave the surface open. crease (rad): edges of the outline that turn by
// less are shaded as one smooth surface.
Mesh revolved(const std::vector<Vec2>& outline, int segments, double crease = kCreaseAngle);

// The unit sphere about the origin. Circles of latitude have as many pieces as their size needs.
Mesh unit_sphere(int segments);
// The same sphere with at most `most_around` pieces per circle of latitude.
Mesh unit_sphere(int segments, int most_around);
// A cylinder of radius 1 from z = 0 to z = 1, with caps.
Mesh unit_cylinder(int segments);
// A cone with its base (radius 1, closed) at z = 0 and its apex at z = 1.
Mesh unit_cone(int segments);
// The unit disc in the plane z = 0, facing +z.
Mesh unit_disc(int segments);
// A dial in the plane z = 0 for a material that is `soft`: the unit circle, and inside it a tick
// every 30 degrees, long ones along the axes. The z of the normals falls from 1, in the middle of
// each line, to 0 at its sides, `half_width` away.
Mesh dial(int segments, double half_width);
// A square grid of lines on a floor (frame/shadow.h), in the plane z = 0 for a material that is
// `soft`, inside the unit circle: towards its rim the lines fade as the floor does. through: a
// point where two lines cross; angle (rad): from +x to one of them.
Mesh floor_grid(const Vec2& through, double angle, double spacing, double half_width);
// The same with circles about `center`, which is inside the unit circle, and a spoke every 30
// degrees from the first of them on; angle (rad): from +x to one of them.
Mesh polar_floor_grid(const Vec2& center, double angle, double spacing, double half_width);
// A sector on such a floor, which fades in the same way. tip: inside the unit circle; angle: from
// +x to its middle; half_angle: between that and each side; rad.
Mesh floor_sector(const Vec2& tip, double angle, double half_angle);
// A torus about z. radius: distance of the tube's centre from the axis; tube: radius of the tube.
Mesh torus(double radius, double tube, int segments);
// The open cone r = z for z in 0..1 with its apex at the origin (half-angle 45 degrees, to be
// scaled).
Mesh unit_cone_shell(int segments);
// A box about the origin with these edge lengths.
Mesh box(const Vec3& size);

// A triangle mesh of the scene for drawing, m. At each corner, faces whose normals differ by less
// than kCreaseAngle are shaded as one smooth surface.
Mesh faceted(const TriangleMesh& surface);

// A coarser mesh for shadows: the box around the mesh is divided into `cells` parts along each
// axis, and vertices in the same cell become one, the first of them. Its normals are those of the
// first.
Mesh clustered(const Mesh& mesh, int cells);

// The mesh scaled by a positive factor per axis, with correct normals.
Mesh scaled(const Mesh& mesh, const Vec3& factors);

}  // namespace polhode
