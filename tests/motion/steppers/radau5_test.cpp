// SPDX-License-Identifier: MIT
// What an L-stable method is for: damping that is much faster than the rest of the motion. Its
// order is tested with that of all methods (stepper_test.cpp).
#include <cmath>

#include <gtest/gtest.h>

#include "motion/simulate.h"
#include "support/loads.h"
#include "support/residual.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

Simulation damped_by(double c, const Vec3& moments, double duration, const char* method) {
  LoadSpec damping = load("damping");
  damping.c = c;
  damping.of = "spin";
  MotionSpec spec = spun({0.4, -1.3, 1.0}, duration);
  spec.torque = {damping};
  NumericsSpec numerics;
  numerics.method = method;
  return simulate(make_model(body_with(moments), spec), spec, numerics, 1e-6);
}

// a ball turns by |w| I / c about a fixed axis, then stands still
TEST(Radau5, BallStopsAfterTheAngleOfTheory) {
  for (const double c : {1e3, 1e6}) {
    const Simulation found = damped_by(c, Vec3(2, 2, 2), 10.0, "radau5");
    const Vec3 w(0.4, -1.3, 1.0);
    const Quat end = found.motion.at(0.0).q_SB * exp_rotation(w * (2.0 / c));
    expect_residual(fmt::format("attitude at the end, c = {:g}", c),
                    rotation_angle_between(found.motion.at(10.0).q_SB, end),
                    1e-6);
    expect_residual("rate at the end", found.motion.at(10.0).w_B.norm(), 1e-9);
    EXPECT_LT(found.report.record.steps, 2000);
  }
}

TEST(Radau5, IsTakenWhereDampingIsStiff) {
  const Simulation stiff = damped_by(1e6, Vec3(0.9, 1.2, 1.6), 10.0, "auto");
  EXPECT_EQ(stiff.report.method, "radau5");
  EXPECT_NE(stiff.report.method_reason.find("damping"), std::string::npos);
  EXPECT_TRUE(stiff.report.reliability.doubts.empty());
  EXPECT_NE(damped_by(0.1, Vec3(0.9, 1.2, 1.6), 10.0, "auto").report.method, "radau5");
}

// where explicit methods can do it too, both agree
TEST(Radau5, AgreesWithAnExplicitMethod) {
  const Simulation a = damped_by(20.0, Vec3(0.9, 1.2, 1.6), 3.0, "radau5");
  const Simulation b = damped_by(20.0, Vec3(0.9, 1.2, 1.6), 3.0, "dop853");
  double worst = 0.0;
  for (int i = 0; i <= 100; ++i)
    worst = worse(worst,
                  rotation_angle_between(a.motion.at(0.03 * i).q_SB, b.motion.at(0.03 * i).q_SB));
  expect_residual("radau5 against dop853", worst, 2e-6);
}

}  // namespace
}  // namespace polhode::test
