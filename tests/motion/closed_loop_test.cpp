// SPDX-License-Identifier: MIT
#include "motion/closed_loop.h"

#include <gtest/gtest.h>

#include "support/motions.h"

namespace polhode {
namespace {

// precession |L|/I1 and spin both 72 degrees a second: back after 5 s
// (scenes/free_symmetric_top.toml)
TEST(Loop, ClosesWhenSpinAndPrecessionDo) {
  MotionSpec spec;
  spec.duration = 12.0;
  spec.attitude.zxz = Vec3(0.0, std::acos(2.0 / 3.0), 0.0);
  spec.spin.rates = Vec3(0.4 * kPi, 0.0, 0.4 * kPi);
  const Loop loop = find_loop(test::moving(test::prolate_body(), spec), 12.0, 0.01);
  EXPECT_NEAR(loop.duration, 5.0, 1e-6);
  EXPECT_LT(loop.residual, 1e-5);
}

// irrational ones close as well as they can in the time that there is: longer looks are no worse
TEST(Loop, TakesTheBestThereIs) {
  const Motion motion = test::moving(test::prolate_body(), [] {
    MotionSpec spec = test::wobbling();
    spec.duration = 60.0;
    return spec;
  }());
  double last = 1e9;
  for (const double longest : {5.0, 15.0, 60.0}) {
    const Loop loop = find_loop(motion, longest, 1e-9);
    EXPECT_LE(loop.duration, longest + 1e-9);
    EXPECT_LE(loop.residual, last + 1e-9);
    last = loop.residual;
  }
  // and what is allowed is taken as soon as it is there
  const Loop early = find_loop(motion, 60.0, 1.0);
  EXPECT_LE(early.residual, 1.0);
  EXPECT_LE(early.duration, find_loop(motion, 60.0, last).duration);
}

// the end of the motion is a loop too, but not the shortest
TEST(Loop, TheShortestIsTaken) {
  MotionSpec spec;
  spec.duration = 4.0;
  spec.spin.body = Vec3(0.0, 0.0, 2.0 * kPi);  // a turn a second
  const Loop loop = find_loop(test::moving(test::prolate_body(), spec), 3.0, 0.01);
  EXPECT_NEAR(loop.duration, 1.0, 1e-6);
}

// a rod on its end, which swings by so little that it hardly turns in a period: 2 pi sqrt(2 l / 3
// g) and a little more, by the radius of the rod and the size of the swing
TEST(Loop, ClosesAfterOneSmallSwing) {
  SolidSpec rod;
  rod.kind = "rod";
  rod.length = 1.0;
  rod.radius = 0.01;
  rod.mass = 1.0;
  BodySpec body = test::body_of(rod);
  body.pivot = Vec3(0.0, 0.0, 0.5);
  const double period = 2.0 * kPi * std::sqrt(2.0 / (3.0 * 9.80665));
  const auto loop_of = [&](double tilt, double push) {
    MotionSpec spec;
    spec.hold = "pivot";
    spec.duration = 12.0;
    spec.attitude.zxz = Vec3(0.0, tilt, 0.0);
    spec.spin.body = Vec3(push, 0.0, 0.0);
    return find_loop(test::moving(body, spec), 12.0, 0.0349);
  };
  for (const auto& [tilt, push] :
       {std::pair(0.0, 0.05), {0.0, 0.08}, {0.0, 0.3}, {0.0, 1e-6}, {0.009, 0.0}, {0.035, 0.0}}) {
    SCOPED_TRACE(testing::Message() << tilt << " rad, " << push << " rad/s");
    const Loop loop = loop_of(tilt, push);
    EXPECT_NEAR(loop.duration, period, 2e-3);
    EXPECT_LT(loop.residual, 1e-5);
  }
}

// at rest at the start: the angle of a body that an oscillating torque turns is
// tau / (w^2 I) (1 - cos w t)
TEST(Loop, ClosesWithTheLoadThatTurnsTheBody) {
  BodySpec body;
  body.moments = Vec3(0.956, 0.956, 0.445);
  body.mass = 1.0;
  for (const double torque : {0.1, 0.3, 3.0}) {
    MotionSpec spec;
    spec.duration = 11.0;
    LoadSpec load;
    load.kind = "constant";
    load.body = Vec3(torque, 0.0, 0.0);
    load.rate = 3.0;
    spec.torque = {load};
    const Loop loop = find_loop(test::moving(body, spec), 11.0, 0.0349);
    EXPECT_NEAR(loop.duration, 2.0 * kPi / 3.0, 1e-4) << torque;
    EXPECT_LT(loop.residual, 1e-3) << torque;
  }
}

TEST(Loop, OfABodyAtRestIsAnyTime) {
  MotionSpec spec;
  spec.duration = 3.0;
  EXPECT_EQ(find_loop(test::moving(test::prolate_body(), spec), 3.0, 0.01).residual, 0.0);
}

}  // namespace
}  // namespace polhode
