// SPDX-License-Identifier: MIT
// The implicit midpoint rule with the attitude by the Cayley transform.
#include <cmath>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/residual.h"
#include "support/stepping.h"

namespace polhode::test {
namespace {

// Cayley: tan of half the angle is h |omega| / 2, whatever the step
TEST(ImplicitMidpoint, TurnsASphereByTheCayleyTransform) {
  for (const double turn : {0.1, 1.0, 30.0}) {
    const double found = turn_of_sphere("implicit_midpoint", turn);
    expect_residual("Cayley", std::abs(found - 2.0 * std::atan(0.5 * turn)), 1e-15);
  }
}

// M1: whenever Newton converges, energy and |L| are kept to round-off, however large the step
TEST(ImplicitMidpoint, M1KeepsEnergyAtEveryStep) {
  const Problem p = hairer_vilmart();
  const double rate = angular_velocity(p.model, p.start.y).norm();
  for (const double turn : {0.16, 0.5, 1.6, 5.0, 16.0}) {
    const std::unique_ptr<Stepper> midpoint = stepper("implicit_midpoint", p);
    State s = p.start;
    int solved = 0;
    double drift = 0.0;
    try {
      for (; solved < 200; ++solved) {
        midpoint->step(0.0, turn / rate, s);
        drift = worse(drift, std::abs(energy(p, s) / energy(p, p.start) - 1.0));
        drift = worse(drift, std::abs(s.y.norm() / p.start.y.norm() - 1.0));
      }
    } catch (const Error& error) {
      // a step without solution must be reported, and only where steps are absurdly long
      EXPECT_EQ(error.fault(), Fault::check_failed);
      EXPECT_GE(turn, 5.0) << error.what();
    }
    expect_residual(fmt::format("M1 h|w| = {}, {} steps", turn, solved), drift, 3e-14);
  }
}

// M2: Newton's method solves the midpoint rule beyond the limit of fixed-point iteration (h = 2
// here)
TEST(ImplicitMidpoint, M2PassesTheFixedPointLimit) {
  const Problem p{free_body({1, 2, 3}), {Quat::Identity(), {1e-3, 1e-3, 3.0}}};
  const std::unique_ptr<Stepper> midpoint = stepper("implicit_midpoint", p);
  State s = p.start;
  for (int i = 0; i < 100; ++i)
    midpoint->step(0.0, 2.02, s);
  EXPECT_NEAR(energy(p, s) / energy(p, p.start), 1.0, 1e-14);
}

// L.up is kept under gravity too, for any step
TEST(ImplicitMidpoint, KeepsTheVerticalMomentumUnderGravity) {
  const Problem p = heavy_asymmetric();
  for (const double h : {0.05, 0.5}) {
    const Vec3 change =
        momentum_in_space(after("implicit_midpoint", p, h, 200)) - momentum_in_space(p.start);
    expect_residual("L.up", std::abs(change.dot(p.model.up_S)), 2e-13);
    expect_effect("L across", change.norm(), 1e-3);
  }
}

TEST(ImplicitMidpoint, J2OnTheTumblingBox) {
  const Problem p = mujoco_box();
  EXPECT_NEAR(relative_energy(p, after("implicit_midpoint", p, 0.01, 500)), 0.0, 1e-14);
}

}  // namespace
}  // namespace polhode::test
