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

TEST(Loop, OfABodyAtRestIsAnyTime) {
  MotionSpec spec;
  spec.duration = 3.0;
  EXPECT_EQ(find_loop(test::moving(test::prolate_body(), spec), 3.0, 0.01).residual, 0.0);
}

}  // namespace
}  // namespace polhode
