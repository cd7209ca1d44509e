// SPDX-License-Identifier: MIT
#include "motion/steppers/free_flow.h"

#include <gtest/gtest.h>

#include "support/residual.h"
#include "support/stepping.h"
#include "support/taylor_oracle.h"

namespace polhode::test {
namespace {

State flowed(const Problem& p, double t) {
  State s = p.start;
  FreeFlow(p.model)(t, s.q, s.y);
  return s;
}

// by the series, and beyond eight radians by the closed form
TEST(FreeFlow, IsExactForAsymmetricBodiesNearAndFar) {
  const Vec3 starts[] = {
      {1.8, 0.4, -0.9}, {0, 0, 2}, {0, 1e-7, -2}, {1e-3, 2, 1e-3}, {-3, 0, 1e-9}};
  for (const Vec3& y : starts) {
    const Problem p{free_body({0.6, 0.8, 1.0}), {exp_rotation({0.2, 0.5, 0.1}), y}};
    for (const double t : {0.01, 1.0, -8.0}) {
      const State exact = TaylorOracle(p.model, p.start).at(t);
      expect_residual("free flow", distance(flowed(p, t), exact), 2e-14);
    }
  }
}

TEST(FreeFlow, IsExactForSymmetricBodiesAndRotators) {
  for (const Vec3& moments : {Vec3(1, 1, 1.8), Vec3(0.4, 1, 1), Vec3(1, 0.3, 1), Vec3(1, 1, 1)}) {
    const Problem p{free_body(moments), {exp_rotation({0.2, 0.5, 0.1}), {0.8, -0.3, 1.1}}};
    expect_residual(
        "symmetric", distance(flowed(p, 50.0), TaylorOracle(p.model, p.start).at(50.0L)), 5e-14);
  }
  const Problem rotator{free_body({1, 1, 0}), {exp_rotation({1.5, 0.2, 0.1}), {0.3, 1.2, 0.0}}};
  const State wanted{rotator.start.q * exp_rotation(7.0 * rotator.start.y), rotator.start.y};
  expect_residual("rotator", distance(flowed(rotator, 7.0), wanted), 1e-14);
}

TEST(FreeFlow, DoesNotSeeGravity) {
  const Problem heavy = heavy_asymmetric();
  const Problem free{free_body(heavy.model.moments), heavy.start};
  for (const double t : {0.3, 20.0})
    EXPECT_LE(distance(flowed(heavy, t), flowed(free, t)), 1e-14) << t;
}

TEST(FreeFlow, IsAGroupInTime) {
  for (const double t : {0.2, -1.3, 9.0}) {
    Problem p = hairer_vilmart();
    p.start = flowed(p, t);
    expect_residual("back", distance(flowed(p, -t), hairer_vilmart().start), 3e-14);
    const State both = flowed(p, 0.7);
    expect_residual("sum", distance(both, flowed(hairer_vilmart(), t + 0.7)), 3e-14);
  }
}

}  // namespace
}  // namespace polhode::test
