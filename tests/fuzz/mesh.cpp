// SPDX-License-Identifier: MIT
// Mesh files: the bytes as OBJ and as STL.
#include <cmath>

#include "base/error.h"
#include "fuzz/harness.h"
#include "model/triangle_mesh.h"

namespace polhode {

void run_harness(const std::string& bytes) {
  for (const char* name : {"a.obj", "a.stl"}) {
    try {
      const TriangleMesh mesh = parse_triangle_mesh(bytes, name);
      check_solid(mesh);
      promise(volume_of(mesh) > 0.0, "a solid has a volume");
      const MassProperties mass = mass_properties_of(mesh);
      promise(mass.center.allFinite() && mass.tensor.allFinite(), "a solid has finite moments");
    } catch (const Error&) {
      continue;
    }
  }
}

}  // namespace polhode
