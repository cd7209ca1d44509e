// SPDX-License-Identifier: MIT
#include "motion/scales.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "motion/motion.h"
#include "motion/simulate.h"
#include "support/loads.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

BodyModel with_torque(const LoadSpec& spec) {
  MotionSpec motion = spun({1, 0, 0});
  motion.torque = {spec};
  return make_model(body_with({1, 2, 2.5}), motion);
}

TEST(TypicalRate, IsTheSpinAndTheSwingOfGravity) {
  const State spinning{Quat::Identity(), {0.6, 0.0, 0.8 * 2.5}};
  EXPECT_DOUBLE_EQ(typical_rate(free_body({1, 2, 2.5}), spinning), std::hypot(0.6, 0.8));
  // a pendulum's small swings: sqrt(m g l / I)
  const BodyModel pendulum = heavy_body({4, 4, 5}, {0, 0, 9});
  EXPECT_DOUBLE_EQ(typical_rate(pendulum, State()), 1.5);
  EXPECT_EQ(typical_rate(free_body({1, 2, 2.5}), State()), 0.0);
}

// a rotator's missing moment is no moment at all, not one that makes the rate infinite
TEST(TypicalRate, OfARotatorIsFinite) {
  EXPECT_DOUBLE_EQ(typical_rate(heavy_body({4, 4, 0}, {0, 0, 9}), State()), 1.5);
}

TEST(TypicalRate, GrowsWithEveryLoad) {
  LoadSpec torque = load("constant");
  torque.body = Vec3(0, 0, 0.09);
  EXPECT_DOUBLE_EQ(typical_rate(with_torque(torque), State()), 0.3);
  LoadSpec damping = load("damping");
  damping.c = 0.7;
  EXPECT_DOUBLE_EQ(typical_rate(with_torque(damping), State()), 0.7);
}

TEST(MomentumScale, IsNeverZero) {
  EXPECT_DOUBLE_EQ(momentum_scale(free_body({1, 2, 2.5}), {Quat::Identity(), {0, 3, 4}}), 5.0);
  EXPECT_EQ(momentum_scale(free_body({1, 2, 2.5}), State()), 1.0);
  // what gravity gives: sqrt(I m g l)
  EXPECT_DOUBLE_EQ(momentum_scale(heavy_body({4, 4, 1}, {0, 0, 9}), State()), 6.0);
  LoadSpec torque = load("constant");
  torque.body = Vec3(0, 0, 0.09);
  EXPECT_DOUBLE_EQ(momentum_scale(with_torque(torque), State()), 2.5 * 0.3);
}

// a body at rest that a force drives: after the radius of gyration, 1.5 m, it has sqrt(F m d), but
// for the factor of sqrt(2)
TEST(LinearMomentumScale, IsWhatForcesGive) {
  BodySpec body = body_with({1, 2, 2.25});
  body.mass = 1.0;
  LoadSpec force = load("force");
  force.space = Vec3(0, 0, 6);
  MotionSpec motion;
  for (const double from : {-1.0, 1.0}) {
    force.from = from > 0.0 ? std::optional(from) : std::nullopt;
    motion.torque = {force};
    const BodyModel model = make_model(body, motion);
    EXPECT_DOUBLE_EQ(linear_momentum_scale(model, 0.015), 3.0);
    EXPECT_DOUBLE_EQ(linear_momentum_scale(model, 15.0), 10.0);
  }
}

// the local error of order p grows as the p-th power of the step: ten times less is asked, the
// step falls by 10^(1/p)
TEST(FirstStep, FollowsToleranceAndOrder) {
  const BodyModel model = free_body({1, 1, 1});
  const State spinning{Quat::Identity(), {0, 0, 2}};
  EXPECT_DOUBLE_EQ(first_step(model, spinning, 1e-10, 5), 0.5 * 1e-2 / 2.0);
  EXPECT_NEAR(first_step(model, spinning, 1e-9, 5) / first_step(model, spinning, 1e-10, 5),
              std::pow(10.0, 0.2),
              1e-14);
  EXPECT_EQ(first_step(model, State(), 1e-10, 5), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace polhode::test
