// SPDX-License-Identifier: MIT
#include "frame/stand.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "frame/mesh_measures.h"

namespace polhode {
namespace {

// a closed surface from the base plate, which is as wide as it says, to the tip at the pivot
TEST(Stand, ReachesFromTheFootToThePivot) {
  for (const int segments : {24, 96}) {
    const Mesh mesh = stand_mesh(0.55, segments);
    EXPECT_EQ(test::open_edges(mesh), 0);
    EXPECT_GT(test::signed_volume(mesh), 0.0);
    float low = 0.0f, high = -1.0f, widest = 0.0f;
    for (const Vertex& vertex : mesh.vertices) {
      low = std::min(low, vertex.position.z);
      high = std::max(high, vertex.position.z);
      widest = std::max(widest, std::hypot(vertex.position.x, vertex.position.y));
      if (vertex.position.z == 0.0f) {
        EXPECT_EQ(vertex.position.x, 0.0f);
        EXPECT_EQ(vertex.position.y, 0.0f);
      }
    }
    EXPECT_EQ(low, -0.55f);
    EXPECT_EQ(high, 0.0f);
    EXPECT_NEAR(widest, kStandFoot, 0.005 * kStandFoot);
  }
}

// near the pivot the stand keeps within a narrow cone, where bodies have room for it
TEST(Stand, KeepsAwayFromTheBody) {
  for (const int segments : {8, 24, 200}) {
    const Mesh mesh = stand_mesh(0.55, segments);
    for (const Vertex& vertex : mesh.vertices) {
      const double depth = -vertex.position.z;
      if (depth > 0.5 * 0.55) continue;
      const double radius = std::hypot(vertex.position.x, vertex.position.y);
      EXPECT_LE(radius, kStandClearance * depth) << depth;
    }
  }
}

}  // namespace
}  // namespace polhode
