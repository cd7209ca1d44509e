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
  std::vector<std::array<int, 3>> triangles;  // indices of points
};

// A mesh from the bytes of an OBJ or STL file (ASCII or binary); the ending of `name` says which.
// Corners at the same place become one; faces with more corners, which must be convex, are cut
// into triangles. Throws Error (input): broken files, NaN, indices out of range, no faces.
TriangleMesh parse_triangle_mesh(const std::string& bytes, const std::string& name);

// Throws Error (input) saying what is wrong and where unless the mesh is the outside of one or more
// solids: every triangle has an area, every edge has exactly one neighbour that runs the other way,
// no triangles touch but at shared corners and edges, and the volume is positive. Intersections
// are decided by exact predicates (CGAL).
void check_solid(const TriangleMesh& mesh);

// Volume (m^3) enclosed by the mesh; negative when it is inside out.
double volume_of(const TriangleMesh& mesh);

// Mass properties per kilogram: .mass is 1, .tensor in m^2 about the centre. Integrals over the
// volume as sums over the triangles by the divergence theorem, exact for the polyhedron (Mirtich,
// "Fast and accurate computation of polyhedral mass properties", J. Graphics Tools 1(2), 1996;
// here in the form of signed tetrahedra, taken from a point of the mesh so that nothing large
// cancels far from the origin).
MassProperties mass_properties_of(const TriangleMesh& mesh);

// Reads, scales and checks a mesh file. Throws as the functions above.
TriangleMesh load_solid_mesh(const std::filesystem::path& file, double scale);

}  // namespace polhode
