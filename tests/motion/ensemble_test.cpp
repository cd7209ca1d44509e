// SPDX-License-Identifier: MIT
#include "motion/ensemble.h"

#include <gtest/gtest.h>

#include "math/so3.h"
#include "support/expect_error.h"
#include "support/motions.h"

namespace polhode {
namespace {

MotionSpec spec_with(double tilt, double momentum) {
  MotionSpec spec = test::wobbling();
  spec.ensemble = EnsembleSpec{300, tilt, momentum};
  return spec;
}

// all lie in the balls, and fill them: half of the points beyond 0.79 of the radius
TEST(Ensemble, StartsFillTheBalls) {
  const MotionSpec spec = spec_with(0.1, 0.02);
  const BodyModel model = make_model(test::brick_body(), spec);
  const State start = start_state(model, spec);
  const std::vector<MotionSpec> members = ensemble_of(model, spec);
  ASSERT_EQ(members.size(), 300U);
  int far = 0;
  Vec3 mean = Vec3::Zero();
  for (const MotionSpec& member : members) {
    const State s = start_state(model, member);
    const double turned = rotation_angle_between(s.q, start.q);
    const Vec3 change = s.q * s.y - start.q * start.y;
    EXPECT_LE(turned, 0.1 + 1e-12);
    EXPECT_LE(change.norm(), 0.02 * start.y.norm() + 1e-12);
    far += turned > 0.0794 ? 1 : 0;
    mean += change / (0.02 * start.y.norm()) / 300.0;
    EXPECT_EQ(member.duration, spec.duration);
    EXPECT_FALSE(member.ensemble);
  }
  EXPECT_NEAR(far, 150, 35);
  EXPECT_LT(mean.norm(), 0.1);
}

// turned alone, a free body keeps its momentum in space, and the other way round
TEST(Ensemble, EachBallIsForItself) {
  const BodyModel model = make_model(test::brick_body(), test::wobbling());
  const State start = start_state(model, test::wobbling());
  for (const MotionSpec& member : ensemble_of(model, spec_with(0.1, 0.0))) {
    const State s = start_state(model, member);
    EXPECT_LT((s.q * s.y - start.q * start.y).norm(), 1e-12);
  }
  for (const MotionSpec& member : ensemble_of(model, spec_with(0.0, 0.1)))
    EXPECT_LT(rotation_angle_between(start_state(model, member).q, start.q), 1e-12);
}

TEST(Ensemble, NeedsSomethingThatDiffers) {
  const MotionSpec spec = spec_with(0.0, 0.0);
  const BodyModel model = make_model(test::brick_body(), spec);
  test::expect_input_error([&] { ensemble_of(model, spec); }, "motion.ensemble", "begin alike");
  EXPECT_TRUE(ensemble_of(model, test::wobbling()).empty());
}

}  // namespace
}  // namespace polhode
