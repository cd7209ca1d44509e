// SPDX-License-Identifier: MIT
// Closed triangle meshes as homogeneous solids: reading, checking, mass properties.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "math/notation.h"
#include "model/mass_properties.h"

namespace polhode {

// A surface of triangles, corners counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Vec3> points;                   // m, no two at the same place
  std::vector<std::array<int, 3>> triangles;  // indices into points
};

// A mesh from the bytes of an OBJ or STL file (ASCII or binary); the ending of `name` says which.
// Its points are in the unit of the file. Vertices at the same place are merged, and convex faces
// with more than three corners are split into triangles. Throws Error (input), naming the file in
// the message, for another ending, broken files, coordinates that are not finite, indices out of
// range, faces with fewer than three corners and files without faces.
TriangleMesh parse_triangle_mesh(const std::string& bytes, const std::string& name);

// Throws Error (input), with the reason and the place in the mesh, unless the mesh is the surface
// of one or more solids: every triangle has an area, every edge is shared by exactly two triangles
// with opposite directions, triangles meet only at shared vertices and edges, and the volume is
// positive. Intersections are tested with exact predicates (CGAL).
void check_solid(const TriangleMesh& mesh);

// Volume (m^3) enclosed by a closed mesh of at least one triangle; negative when it is inside out.
double volume_of(const TriangleMesh& mesh);

// Mass properties of a mesh that passes check_solid(), per kilogram: .mass is 1, .center is the
// centroid (m, in the axes of the mesh), .tensor in m^2 about it. The volume integrals are sums
// over triangles by the divergence theorem, exact for the polyhedron (Mirtich, "Fast and accurate
// computation of polyhedral mass properties", J. Graphics Tools 1(2), 1996; here as signed
// tetrahedra with a common point of the mesh as apex, which avoids cancellation far from the
// origin).
MassProperties mass_properties_of(const TriangleMesh& mesh);

// Reads a mesh file of at most 64 MiB, multiplies it by `scale` (metres per unit of the file,
// positive) and checks it. Throws Error (input) as parse_triangle_mesh, check_solid and read_file
// (base/system/atomic_file.h) do.
TriangleMesh load_solid_mesh(const std::filesystem::path& file, double scale);

}  // namespace polhode
