// SPDX-License-Identifier: MIT
#include "frame/elements/parts.h"

#include <gtest/gtest.h>

#include "frame/compose.h"
#include "support/motions.h"

namespace polhode {
namespace {

Scenery scenery_of(const BodySpec& body, const MotionSpec& motion) {
  return make_scenery(test::moving(body, motion), body, ThemeSpec{}, ShowSpec{}, 32);
}

// L = I w in principal axes, and w.L is twice the energy
TEST(Parts, PrincipalAxesDiagonaliseTheMotion) {
  const Scenery scenery = scenery_of(test::brick_body(), test::wobbling());
  const BodyModel& model = scenery.motion.model();
  const Sample now = scenery.motion.at(1.3);
  const Vec3 w_P = principal_rate(model, now);
  const Mat3 R_SP = principal_placement(scenery, now).linear();
  EXPECT_LT((R_SP * model.moments.cwiseProduct(w_P) - now.L_S).norm(), 1e-12 * now.L_S.norm());
  EXPECT_NEAR(twice_the_energy(model, w_P), now.w_S.dot(now.L_S), 1e-12 * now.w_S.dot(now.L_S));
}

TEST(Parts, ADiscLiesSquareToItsNormal) {
  const Vec3 center(1, 2, 3), normal = Vec3(1, -1, 0.5).normalized();
  const Placement place = disc_placement(center, normal, 0.5);
  Glyphs glyphs;
  add_rim_reach(place, 12, glyphs);
  ASSERT_EQ(glyphs.reach.size(), 12u);
  for (const Vec3& point : glyphs.reach) {
    EXPECT_NEAR((point - center).norm(), 0.5, 1e-15);
    EXPECT_NEAR((point - center).dot(normal), 0.0, 1e-15);
  }
}

// names fade in with the length of their vectors, from 0.08 to 0.11 of the body's radius
TEST(Parts, ShortVectorsHaveNoName) {
  const Scenery scenery = scenery_of(test::prolate_body(), test::wobbling());
  const auto fade_of = [&](double length) -> float {
    Glyphs glyphs;
    const Vec3 end = length * scenery.scale.body * Vec3::UnitX();
    add_vector(scenery, Vec3::Zero(), end, kOmegaShape, {}, glyphs, "name");
    EXPECT_EQ(glyphs.arrows.size(), 1u);
    return glyphs.labels.empty() ? 0.0f : glyphs.labels[0].fade;
  };
  EXPECT_EQ(fade_of(0.07), 0.0f);
  EXPECT_NEAR(fade_of(0.095), 0.5f, 1e-6f);
  EXPECT_EQ(fade_of(0.12), 1.0f);
}

// what a scene cannot have is refused with the reason
TEST(Parts, ConditionsSayWhatIsMissing) {
  const Scenery free = scenery_of(test::prolate_body(), test::wobbling());
  const Scenery brick = scenery_of(test::brick_body(), test::wobbling());
  const Scenery heavy = scenery_of(test::cone_body(), test::spinning_on_pivot());
  EXPECT_EQ(needs_cones(free), "");
  EXPECT_NE(needs_cones(brick), "");
  EXPECT_NE(needs_cones(heavy), "");
  EXPECT_EQ(needs_free(brick), "");
  EXPECT_NE(needs_free(heavy).find("no torque turns"), std::string::npos);
  EXPECT_EQ(needs_pivot(heavy), "");
  EXPECT_NE(needs_pivot(free).find("pivot"), std::string::npos);
  EXPECT_NE(needs_forces(free).find("force"), std::string::npos);
  EXPECT_TRUE(stays_above_stand(heavy));
  MotionSpec hanging = test::spinning_on_pivot();
  hanging.attitude.zxz = Vec3(0.0, 3.0, 0.0);
  EXPECT_FALSE(stays_above_stand(scenery_of(test::cone_body(), hanging)));
}

}  // namespace
}  // namespace polhode
