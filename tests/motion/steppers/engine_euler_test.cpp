// SPDX-License-Identifier: MIT
// The steps of physics engines: what each does to the angular momentum, as identities.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/residual.h"
#include "support/stepping.h"

namespace polhode::test {
namespace {

// the momentum of explicit Euler, and the attitude by the new angular velocity
TEST(EngineEuler, SemiImplicitTurnsByTheNewAngularVelocity) {
  const Problem p = hairer_vilmart();
  const double h = 0.1;
  const State s = after("semi_implicit_euler", p, h, 1);
  EXPECT_LE((s.y - after("explicit_euler", p, h, 1).y).norm(), 1e-15);
  const Quat wanted = p.start.q * exp_rotation(h * angular_velocity(p.model, s.y));
  EXPECT_LE(rotation_angle_between(s.q, wanted), 1e-15);
}

// y' - y - h y' x w' is quadratic in y': after one step of Newton's method from y what remains of
// it is the quadratic part alone, -h d x (I^-1 d) with d = y' - y
TEST(EngineEuler, LinearlyImplicitIsOneStepOfNewtonsMethod) {
  const Problem p = hairer_vilmart();
  for (const double h : {0.01, 0.1, 1.0}) {
    const Vec3 y = after("linearly_implicit_euler", p, h, 1).y;
    const Vec3 d = y - p.start.y;
    const Vec3 left = d - h * y.cross(angular_velocity(p.model, y));
    const Vec3 wanted = -h * d.cross(angular_velocity(p.model, d));
    expect_residual("Newton", (left - wanted).norm(), 2e-15);
    expect_effect("not solved", left.norm(), std::min(0.05 * h * h * h, 1e-4));  // |d|^2 h
  }
}

// J1: 2 (E' - E) = -|L|^4 det(J - J_L) h^2 / (1 + h^2 k^2 / L^2), J = I^-1, J_L = 2 E / L^2,
// k = y x w: the energy goes to that of the middle axis
TEST(EngineEuler, J1RenormalisedStepTumblesAStableSpin) {
  Problem p{free_body({1, 2, 3}), {Quat::Identity(), {0.03, 0.03, 3.0}}};
  const std::unique_ptr<Stepper> by = stepper("renormalised_explicit", p);
  const double h = 1.0 / 60.0;
  const double L2 = p.start.y.squaredNorm();
  State s = p.start;
  double worst = 0.0;
  for (int i = 0; i < 60 * 900; ++i) {
    const double before = 2.0 * energy(p.model, s);
    const double J_L = before / s.y.squaredNorm();
    const double det = (p.model.inverse_moments.array() - J_L).prod();
    const double k2 = s.y.cross(angular_velocity(p.model, s.y)).squaredNorm();
    by->step(0.0, h, s);
    const double wanted = -L2 * L2 * det * h * h / (1.0 + h * h * k2 / L2);
    worst = worse(worst, std::abs(2.0 * energy(p.model, s) - before - wanted));
  }
  expect_residual("J1 identity", worst, 1e-14);
  EXPECT_NEAR(2.0 * energy(p.model, s) / L2, 0.5, 0.01);  // 1 / I2, from 1 / I3
  expect_residual("J1 |L|", std::abs(s.y.norm() / p.start.y.norm() - 1.0), 3e-13);
}

// J2: MuJoCo's box again, with the engines' steps
TEST(EngineEuler, J2EnginesOnTheTumblingBox) {
  const Problem p = mujoco_box();
  const auto ratio = [&](const char* method) {
    return 1.0 + relative_energy(p, after(method, p, 0.01, 500));
  };
  EXPECT_NEAR(ratio("semi_implicit_euler"), 1.08689455, 1e-8);
  EXPECT_NEAR(ratio("linearly_implicit_euler"), 0.92600827, 1e-8);
}

}  // namespace
}  // namespace polhode::test
