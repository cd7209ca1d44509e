// SPDX-License-Identifier: MIT
// The closed forms of spherical and symmetric free tops (motion/exact/symmetric.cpp).
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "motion/exact/exact.h"
#include "motion/grid_trajectory.h"
#include "motion/stepper_table.h"
#include "motion/trajectory.h"
#include "support/residual.h"
#include "support/taylor_oracle.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;

const State kStart{exp_rotation({0.4, -1.3, 0.8}), {0.9, -0.4, 1.7}};

std::vector<Vec3> symmetric_moments() {
  return {{1, 1, 1.8}, {1, 1, 0.2}, {1.8, 1, 1}, {1, 0.2, 1}, {1, 1, 2}, {2, 2, 1e-3}};
}

TEST(ExactSpherical, TurnsUniformlyAboutL) {
  const BodyModel model = free_body({0.4, 0.4, 0.4});
  const auto trajectory = exact_spherical(model, kStart);
  TaylorOracle oracle(model, kStart);
  double worst = 0.0;
  for (int i = 0; i <= 100; ++i)
    worst = worse(worst, distance(trajectory->at(0.1 * i), oracle.at(0.1 * i)));
  expect_residual("spherical, t = 10", worst, 2e-14);  // 49 rad at half a digit
}

TEST(ExactSymmetric, AgreesWithTheOracleForEveryAxisAndShape) {
  for (const Vec3& moments : symmetric_moments()) {
    const BodyModel model = free_body(moments);
    State start = kStart;
    if (moments.minCoeff() < 0.01) start.y *= 0.01;
    const auto trajectory = exact_symmetric(model, start);
    TaylorOracle oracle(model, start);
    double worst = 0.0;
    for (int i = 1; i <= 100; ++i)
      worst = worse(worst, distance(trajectory->at(0.1 * i), oracle.at(0.1 * i)));
    expect_residual(
        fmt::format("symmetric ({}, {}, {}), t = 10", moments[0], moments[1], moments[2]),
        worst,
        // half a digit of the angle turned
        2e-15 + 2e-16 * 10.0 * angular_velocity(model, start.y).norm());
  }
}

TEST(ExactSymmetric, AgreesWithATightIntegration) {
  const BodyModel model = free_body({1, 1, 1.8});
  const auto exact = exact_symmetric(model, kStart);
  const auto ode = integrate_adaptive(find_stepper("dopri5"), model, kStart, 10.0, 1e-13);
  double worst = 0.0;
  for (int i = 0; i <= 100; ++i)
    worst = worse(worst, distance(ode.trajectory->at(0.1 * i), exact->at(0.1 * i)));
  expect_residual("symmetric against dopri5 1e-13", worst, 1e-11);
}

TEST(ExactSymmetric, KeepsEveryInvariantToRoundOff) {
  for (const Vec3& moments : symmetric_moments()) {
    const BodyModel model = free_body(moments);
    const auto trajectory = exact_symmetric(model, kStart);
    DriftWatch watch(model, kStart);
    double off_sphere = 0.0, spin_change = 0.0;
    for (int i = 0; i <= 1000; ++i) {
      const State s = trajectory->at(1.7 * i);
      watch.look_at(s);
      off_sphere = worse(off_sphere, std::abs(s.q.norm() - 1.0));
      spin_change = worse(spin_change, std::abs(s.y[model.kind.axis] - kStart.y[model.kind.axis]));
    }
    expect_residual("energy", watch.worst().energy.value(), 4e-15);
    expect_residual("L in space", watch.worst().momentum.value(), 4e-15);
    expect_residual("|q|", off_sphere, 2e-15);
    expect_residual("spin about the own axis", spin_change, 4e-15);
  }
}

// Landau and Lifshitz, Mechanics, eq. 33.2: the axis goes round L at |L| / I1
TEST(ExactSymmetric, PrecessesAtLOverI1) {
  for (const Vec3& moments : symmetric_moments()) {
    const BodyModel model = free_body(moments);
    const auto trajectory = exact_symmetric(model, kStart);
    const Vec3 L_S = momentum_in_space(kStart);
    const double I1 = moments[(model.kind.axis + 1) % 3];
    // angle about L of the figure axis, from two moments of the trajectory
    const auto across = [&](double t) {
      const Vec3 axis = trajectory->at(t).q * Vec3(Vec3::Unit(model.kind.axis));
      return Vec3(axis - axis.dot(L_S) / L_S.squaredNorm() * L_S);
    };
    const double dt = 0.25 * I1 / L_S.norm();
    const Vec3 a = across(3.0), b = across(3.0 + dt);
    const double turned = std::atan2(a.cross(b).dot(L_S.normalized()), a.dot(b));
    expect_residual("precession rate", std::abs(turned - 0.25), 2e-14);
  }
}

TEST(ExactSymmetric, OneStepOfFiftySecondsIsAsGoodAsAThousand) {
  const BodyModel model = free_body({1, 1, 1.8});
  const State once = exact_symmetric(model, kStart)->at(50.0);
  State s = kStart;
  for (int i = 0; i < 1000; ++i)
    s = exact_symmetric(model, s)->at(0.05);
  expect_residual("S3: one step of 50 s against 1000", distance(s, once), 4e-13);
}

TEST(ExactSymmetric, RotatorIsItsLimit) {
  const BodyModel model = free_body({1, 1, 0});
  const State start{kStart.q, {0.9, -0.4, 0.0}};
  const auto trajectory = exact_symmetric(model, start);
  const Vec3 w = start.q * start.y;
  const Vec3 n0 = start.q * Vec3::UnitZ();
  for (const double t : {0.5, 3.0, 10.0}) {
    // n(t) = cos |w|t n0 + sin |w|t w/|w| x n0
    const double angle = w.norm() * t;
    const Vec3 n = std::cos(angle) * n0 + std::sin(angle) * w.normalized().cross(n0);
    EXPECT_LE((trajectory->at(t).q * Vec3::UnitZ() - n).norm(), 5e-15);
    EXPECT_EQ(trajectory->at(t).y, start.y);
  }
}

TEST(ExactSymmetric, BodyAtRestStaysThere) {
  const State rest{kStart.q, Vec3::Zero()};
  EXPECT_TRUE(same_bits(exact_symmetric(free_body({1, 1, 1.8}), rest)->at(5.0), rest));
}

}  // namespace
}  // namespace polhode
