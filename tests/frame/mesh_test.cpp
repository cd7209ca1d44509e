// SPDX-License-Identifier: MIT
#include "frame/mesh.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/units.h"
#include "frame/mesh_measures.h"

namespace polhode {
namespace {

// corners outside, middles of chords inside, both by at most a quarter of a pixel
TEST(Mesh, DrawnCirclesAreWithinAQuarterPixel) {
  const auto farthest = [](int n, double radius) {
    const Mesh disc = unit_disc(n);
    const glm::vec3 corner = disc.vertices[1].position;
    const glm::vec3 middle = 0.5f * (corner + disc.vertices[2].position);
    const double outside = glm::length(corner) - 1.0;
    const double inside = 1.0 - glm::length(middle);
    EXPECT_NEAR(outside, inside, 1e-6);
    return radius * std::max(outside, inside);
  };
  for (const double radius : {20.0, 100.0, 540.0, 2160.0}) {
    const int n = circle_segments(radius);
    EXPECT_LE(farthest(n, radius), 0.25 + 2e-3) << radius;
    if (n > 16) {
      EXPECT_GT(farthest(n - 1, radius), 0.25) << "wasteful at " << radius;
    }
  }
}

// the unit shapes have the volumes of geometry, within what their polygons lack, and no holes
TEST(Mesh, UnitShapesAreClosedAndHaveTheirVolumes) {
  struct Case {
    const char* name;
    Mesh mesh;
    double volume;
  };
  const Case cases[] = {{"sphere", unit_sphere(128), 4.0 / 3.0 * kPi},
                        {"cylinder", unit_cylinder(128), kPi},
                        {"cone", unit_cone(128), kPi / 3.0},
                        {"torus", torus(1.0, 0.25, 128), 2.0 * kPi * kPi * 0.0625},
                        {"box", box({1, 2, 3}), 6.0},
                        {"scaled", scaled(unit_sphere(128), {1, 2, 3}), 8.0 * kPi}};
  for (const Case& shape : cases) {
    EXPECT_EQ(test::open_edges(shape.mesh), 0) << shape.name;
    EXPECT_NEAR(test::signed_volume(shape.mesh) / shape.volume, 1.0, 4e-3) << shape.name;
  }
}

}  // namespace
}  // namespace polhode
