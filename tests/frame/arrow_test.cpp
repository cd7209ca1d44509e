// SPDX-License-Identifier: MIT
#include "frame/arrow.h"

#include <cmath>

#include <gtest/gtest.h>

#include "frame/composers.h"
#include "frame/to_glm.h"

namespace polhode {
namespace {

using test::drawn;

const ArrowMeshes kArrows = arrow_meshes(32, 32);

std::vector<DrawItem> arrow(const Vec3& from, const Vec3& tip, const ArrowShape& shape) {
  std::vector<DrawItem> items;
  add_arrow(items, kArrows, from, tip, shape, Material{});
  return items;
}

// the apex of the head is the end of the vector, whatever its direction and length, and the shaft
// goes from the foot to the base of the head
TEST(Arrow, EndsExactlyAtTheTip) {
  const ArrowShape shape{0.01, 0.03, 0.09};
  const Vec3 from(0.2, -0.1, 0.4);
  for (const Vec3& vector : {Vec3(0, 0, 1),
                             Vec3(0, 0, -1),
                             Vec3(1, 2, -0.5),
                             Vec3(0.02, 0.01, 0.0),
                             Vec3(-1e-3, 0, 1e-3)}) {
    const std::vector<DrawItem> items = arrow(from, from + vector, shape);
    ASSERT_EQ(items.size(), 2u);
    EXPECT_LT((drawn(items[1], Vec3::UnitZ()) - from - vector).norm(), 1e-6);
    EXPECT_LT((drawn(items[0], Vec3::Zero()) - from).norm(), 1e-6);
    EXPECT_LT((drawn(items[0], Vec3::UnitZ()) - drawn(items[1], Vec3::Zero())).norm(), 1e-6);
  }
}

TEST(Arrow, RadiiAreSquareToTheVector) {
  const ArrowShape shape{0.01, 0.03, 0.09};
  const Vec3 vector(0.3, -0.4, 1.2);
  const std::vector<DrawItem> items = arrow(Vec3::Zero(), vector, shape);
  ASSERT_EQ(items.size(), 2u);
  const double radii[] = {shape.shaft_radius, shape.head_radius};
  for (std::size_t i = 0; i < 2; ++i) {
    for (const Vec3& out : {Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
      const Vec3 across = drawn(items[i], out) - drawn(items[i], Vec3::Zero());
      EXPECT_NEAR(across.norm(), radii[i], 1e-7);
      EXPECT_NEAR(across.dot(vector), 0.0, 1e-7);
    }
  }
}

// the head of a short vector shrinks in proportion, shaft and all
TEST(Arrow, AShortVectorHasASmallerHead) {
  const ArrowShape shape{0.01, 0.03, 0.09};
  const std::vector<DrawItem> items = arrow(Vec3::Zero(), Vec3(0, 0, 0.03), shape);
  ASSERT_EQ(items.size(), 2u);
  const double shrink = 0.02 / 0.09;
  EXPECT_NEAR(drawn(items[1], Vec3::Zero()).z(), 0.01, 1e-8);
  EXPECT_NEAR(drawn(items[1], Vec3::UnitX()).x(), 0.03 * shrink, 1e-8);
  EXPECT_NEAR(drawn(items[0], Vec3::UnitX()).x(), 0.01 * shrink, 1e-8);
}

TEST(Arrow, AVectorOfNoLengthIsNotDrawn) {
  EXPECT_TRUE(arrow(Vec3(1, 2, 3), Vec3(1, 2, 3), ArrowShape{}).empty());
  std::vector<DrawItem> items;
  add_tube(items, kArrows, Vec3(1, 2, 3), Vec3(1, 2, 3), 0.1, Material{});
  EXPECT_TRUE(items.empty());
}

// of two in one line the thin one is seen on both sides of the other; side by side it needs nothing
TEST(Arrow, AThinOneInsideAnotherHasARim) {
  const ArrowShape thin{0.018, 0.05, 0.23}, thick{0.025, 0.064, 0.17};
  const auto rim = [&](double angle, double length = 1.5) {
    return rim_around(
        length * Vec3(std::sin(angle), 0, std::cos(angle)), thin, Vec3(0, 0, 1.3), thick);
  };
  ASSERT_TRUE(rim(0.0));
  EXPECT_GT(rim(0.0)->radius, 1.4 * thick.shaft_radius);
  EXPECT_LT(rim(0.0)->radius, thick.head_radius);
  // as far as both have shafts, whichever is longer
  EXPECT_NEAR(rim(0.0)->length, 1.3 - 0.17, 1e-12);
  EXPECT_NEAR(rim(0.0, 1.0)->length, 1.0 - 0.23, 1e-12);
  EXPECT_FALSE(rim(0.1));
  EXPECT_FALSE(rim(3.14));
  EXPECT_FALSE(rim(0.0, 0.0));
  EXPECT_FALSE(rim_around(Vec3(0, 0, 1.5), thick, Vec3(0, 0, 1.3), thick));
  EXPECT_FALSE(rim_around(Vec3(0, 0, 1.5), thick, Vec3(0, 0, 1.3), thin));
}

// it does not jump while the angle changes: it comes out of the shaft
TEST(Arrow, RimsGrowSmoothly) {
  const ArrowShape thin{0.018, 0.05, 0.23}, thick{0.025, 0.064, 0.17};
  const auto radius = [&](double angle) {
    const auto rim =
        rim_around(1.5 * Vec3(std::sin(angle), 0, std::cos(angle)), thin, Vec3(0, 0, 1.3), thick);
    return rim ? rim->radius : thin.shaft_radius;
  };
  double before = radius(0.0);
  for (int i = 1; i <= 500; ++i) {
    const double now = radius(1e-4 * i);
    EXPECT_LE(now, before);
    EXPECT_LT(before - now, 2e-4) << i;
    before = now;
  }
  EXPECT_EQ(before, thin.shaft_radius);
}

TEST(Arrow, ATubeGoesFromEndToEnd) {
  std::vector<DrawItem> items;
  const Vec3 from(0, 1, 0), to(2, -1, 1);
  add_tube(items, kArrows, from, to, 0.25, Material{});
  ASSERT_EQ(items.size(), 1u);
  EXPECT_LT((drawn(items[0], Vec3::Zero()) - from).norm(), 1e-6);
  EXPECT_LT((drawn(items[0], Vec3::UnitZ()) - to).norm(), 1e-6);
  EXPECT_NEAR((drawn(items[0], Vec3::UnitX()) - from).norm(), 0.25, 1e-6);
}

}  // namespace
}  // namespace polhode
