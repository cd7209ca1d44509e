// SPDX-License-Identifier: MIT
// Small solids as OBJ files.
#pragma once

#include <string>

#include "model/triangle_mesh.h"

namespace polhode::test {

inline const char* const kBox =
    "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 4\nv 2 0 4\nv 2 3 4\nv 0 3 4\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 1 5 8 4\nf 2 3 7 6\n";
inline const char* const kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

inline TriangleMesh obj(const std::string& text) {
  return parse_triangle_mesh(text, "test.obj");
}

inline TriangleMesh solid(const std::string& text) {
  TriangleMesh mesh = obj(text);
  check_solid(mesh);
  return mesh;
}

}  // namespace polhode::test
