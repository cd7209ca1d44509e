// SPDX-License-Identifier: MIT
// The closed form of the heavy symmetric top (motion/exact/heavy_symmetric.cpp).
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/units.h"
#include "motion/exact/exact.h"
#include "motion/trajectory.h"
#include "support/residual.h"
#include "support/taylor_oracle.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;

double worst_until(const Problem& p, double duration, int samples = 50) {
  const auto exact = exact_heavy_symmetric(p.model, p.start);
  TaylorOracle oracle(p.model, p.start);
  double worst = 0.0;
  for (int i = 0; i <= samples; ++i) {
    const double t = duration * i / samples;
    const State a = exact->at(t), b = oracle.at(t);
    // y may pass through zero, so its error counts against what gravity can give it
    const double scale =
        std::max(b.y.norm(), std::sqrt(p.model.moments.maxCoeff() * p.model.chi_P.norm()));
    worst = worse(worst, std::hypot(rotation_angle_between(a.q, b.q), (a.y - b.y).norm() / scale));
  }
  return worst;
}

// How much the motion itself multiplies a relative change of its start, in 64-bit-mantissa
// arithmetic.
double condition(const Problem& p, double duration) {
  double most = 1.0;
  for (int i = 0; i < 3; ++i) {
    Problem beside = p;
    const double scale =
        std::max(p.start.y.norm(), std::sqrt(p.model.moments.maxCoeff() * p.model.chi_P.norm()));
    if (p.model.moments[i] > 0.0) beside.start.y[i] += 1e-10 * scale;
    beside.start.q = p.start.q * exp_rotation(1e-10 * Vec3(Vec3::Unit((i + 1) % 3)));
    TaylorOracle a(p.model, p.start), b(beside.model, beside.start);
    for (int k = 1; k <= 20; ++k) {
      const double t = duration * k / 20;
      most = worse(most, rotation_angle_between(a.at(t).q, b.at(t).q) / 1e-10);
    }
  }
  return most;
}

// with GCC's roundings all are below 4e-16 of it, with Clang's two of 60 random tops reach 5.4e-16
void expect_exact(const std::string& what, const Problem& p, double duration) {
  expect_residual(what, worst_until(p, duration), 1e-14 + 6e-16 * condition(p, duration));
}

const Quat kTilted = exp_rotation({0.4, -0.9, 0.8});

BodyModel top_with(double C, double mu = 1.0) {
  return heavy_body({1, 1, C}, {0, 0, mu});
}

TEST(ExactHeavySymmetric, AgreesWithTheOracleForRandomTops) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 60; ++i) {
    const double C = 1.05 + uniform(random);
    const Problem p{heavy_body({1, 1, C}, {0, 0, 1.5 * uniform(random)}),
                    {exp_rotation(3.0 * Vec3(uniform(random), uniform(random), uniform(random))),
                     3.0 * Vec3(uniform(random), uniform(random), uniform(random))}};
    expect_exact(fmt::format("random top {}", i), p, 10.0);
  }
}

TEST(ExactHeavySymmetric, AxisOfAnyIndexSignAndUpInAnyDirection) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      Vec3 moments(1, 1, 1);
      moments[axis] = 0.6;
      for (const Vec3& up : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0.6, 0, 0.8), Vec3(0, -1, 0)}) {
        const Problem p{heavy_body(moments, sign * Vec3(Vec3::Unit(axis)), up),
                        {kTilted, {0.5, -0.8, 1.1}}};
        expect_exact("turned about", p, 10.0);
      }
    }
  }
}

TEST(ExactHeavySymmetric, SphericalTopWithItsCentreAnywhere) {
  const Problem p{heavy_body({1, 1, 1}, {0.3, -0.5, 0.7}), {kTilted, {0.5, -0.8, 1.1}}};
  expect_exact("spherical, chi askew", p, 10.0);
}

TEST(ExactHeavySymmetric, ReachesTheGniEndState) {
  const Problem p = gni_heavy_top();
  const State expected{
      Quat(-0.43556098558439444, -0.3700636549040742, 0.26480479131047299, -0.77667106399994462),
      Vec3(0.95995717781986385, -0.36416972569944915, 0.4)};
  const auto exact = exact_heavy_symmetric(p.model, p.start);
  expect_residual("GNI 5.3, t = 30", distance(exact->at(30.0), expected), 4e-14);

  // published: nutation period, turn of the node line in it, range of the tilt
  const double period = 2.49679814564629;
  const auto tilt = [&](double t) {
    return zxz_angles(exact->at(t).q)[1];
  };
  EXPECT_NEAR(tilt(7.0 + period), tilt(7.0), 4e-14);
  const double turn = zxz_angles(exact->at(7.0 + period).q)[0] - zxz_angles(exact->at(7.0).q)[0];
  EXPECT_NEAR(std::remainder(turn - 6.12727820661848, 2.0 * kPi), 0.0, 4e-14);
  double least = kPi, most = 0.0;
  for (int i = 0; i < 20000; ++i) {
    least = std::min(least, tilt(i * period / 20000));
    most = worse(most, tilt(i * period / 20000));
  }
  EXPECT_NEAR(least * 180.0 / kPi, 51.64590115, 1e-5);
  EXPECT_NEAR(most * 180.0 / kPi, 121.8203569, 1e-5);
}

TEST(ExactHeavySymmetric, AfterAThousandRotations) {
  const Problem p{top_with(0.6), {kTilted, {0.3, -0.5, 2.0}}};
  const double duration = 1000.0 * 2.0 * kPi / (2.0 / 0.6);
  expect_residual("heavy top, 1000 rotations", worst_until(p, duration, 20), 5e-12);
}

TEST(ExactHeavySymmetric, KeepsEveryInvariantToRoundOff) {
  for (const Vec3& y : {Vec3(0.3, -0.5, 2.0), Vec3(0, 0, 0.3), Vec3(2.0, 1.0, 0.0)}) {
    const Problem p{top_with(0.6), {kTilted, y}};
    const auto exact = exact_heavy_symmetric(p.model, p.start);
    DriftWatch watch(p.model, p.start);
    double off_sphere = 0.0;
    for (int i = 0; i <= 3000; ++i) {
      const State s = exact->at(0.77 * i);
      watch.look_at(s);
      off_sphere = worse(off_sphere, std::abs(s.q.norm() - 1.0));
      EXPECT_EQ(s.y[2], y[2]);
    }
    expect_residual("energy", watch.worst().energy.value(), 5e-15);
    expect_residual("L.up", watch.worst().momentum.value(), 5e-15);
    expect_residual("|q|", off_sphere, 2e-15);
  }
}

// L1: released at rest (a cusp), where the usual start phase loses half of the digits
TEST(ExactHeavySymmetric, L1CuspStart) {
  for (const double spin : {0.3, 1.0, 2.5, 8.0}) {
    for (const double tilt : {1e-6, 0.01, 0.5, 1.5, 3.0}) {
      const Problem p{top_with(0.6), {from_zxz_angles({0.3, tilt, 0.7}), {0, 0, spin}}};
      expect_exact(fmt::format("L1 spin {} tilt {}", spin, tilt), p, 10.0);
    }
  }
}

// the axis passes through the vertical: L_z = L_3 (up) or -L_3 (down)
TEST(ExactHeavySymmetric, PassesThroughTheVertical) {
  for (const double end : {1.0, -1.0}) {
    for (const double L3 : {0.5, 1.3, -0.8}) {
      for (const double y1 : {0.2, 1.5, 3.0}) {
        // with phi = psi = 0 it is gamma = (0, sin, cos), so y2 sin + L3 cos = end L3
        const double tilt = 0.9;
        const double y2 = L3 * (end - std::cos(tilt)) / std::sin(tilt);
        const Problem p{top_with(0.6), {from_zxz_angles({0, tilt, 0}), {y1, y2, L3}}};
        expect_exact(fmt::format("Lz = {} L3, L3 = {}", end, L3), p, 10.0);
      }
    }
  }
}

// starts on the vertical, or next to it by almost nothing
TEST(ExactHeavySymmetric, StartsOnTheVertical) {
  for (const double tilt : {0.0, 1e-300, 1e-18, 1e-12, 1e-8, 1e-4, kPi - 1e-8, kPi}) {
    for (const Vec3& y : {Vec3(0.8, 0.1, 1.2), Vec3(1e-9, 0, 3.0), Vec3(0.5, 0.5, 0.0)}) {
      Problem p{top_with(0.6), {from_zxz_angles({0, tilt, 0.4}), y}};
      if (tilt == kPi) p.start.q = Quat(0, 1, 0, 0);
      expect_exact(fmt::format("start at tilt {:g}", tilt), p, 10.0);
    }
  }
}

// the two steady precessions: phi' (C w3 - A phi' cos) = mu, no nutation
TEST(ExactHeavySymmetric, SteadyPrecessionStaysSteady) {
  const double A = 1.0, C = 0.6, mu = 1.0, L3 = 3.0;
  for (const double tilt : {0.3, 1.0, 2.5}) {
    const double c = std::cos(tilt);
    const double root = std::sqrt(L3 * L3 - 4.0 * A * mu * c);
    for (const double rate : {(L3 - root) / (2.0 * A * c), (L3 + root) / (2.0 * A * c)}) {
      const Vec3 y(0.0, A * rate * std::sin(tilt), L3);
      const Problem p{top_with(C), {from_zxz_angles({0, tilt, 0}), y}};
      expect_exact(fmt::format("steady, tilt {}", tilt), p, 10.0);
      const auto exact = exact_heavy_symmetric(p.model, p.start);
      for (int i = 0; i < 50; ++i) {
        const Vec3 angles = zxz_angles(exact->at(0.3 * i).q);
        EXPECT_NEAR(angles[1], tilt, 2e-15);
        EXPECT_NEAR(std::remainder(angles[0] - rate * 0.3 * i, 2.0 * kPi),
                    0.0,
                    3e-14 * (1.0 + std::abs(rate)));
      }
    }
  }
}

// a top that stands upright spins in place; tilted a little it stays or falls as theory says
TEST(ExactHeavySymmetric, SleepingTop) {
  const double critical = 2.0;  // of L3: L3^2 = 4 A mu
  for (const double ratio : {0.5, 0.95, 0.999999, 1.0, 1.000001, 1.05, 3.0}) {
    const State upright{exp_rotation({0, 0, 0.3}), {0, 0, ratio * critical}};
    const auto sleeping = exact_heavy_symmetric(top_with(0.5), upright);
    const Quat expected = upright.q * exp_rotation({0, 0, 20.0 * ratio * critical / 0.5});
    EXPECT_LE(rotation_angle_between(sleeping->at(20.0).q, expected), 2e-14);
    for (const double tilt : {1e-3, 1e-6, 1e-9}) {
      const Problem p{top_with(0.5), {from_zxz_angles({0.3, tilt, 0}), {0, 0, ratio * critical}}};
      expect_exact(fmt::format("sleeping {} tilt {:g}", ratio, tilt), p, 15.0);
    }
  }
}

TEST(ExactHeavySymmetric, HangingAtRestStaysAndSwingsWhenPushed) {
  const State hanging{Quat(0, 1, 0, 0), Vec3::Zero()};
  EXPECT_LE(distance(exact_heavy_symmetric(top_with(0.6), hanging)->at(9.0), hanging), 1e-15);
  for (const double push : {1e-9, 1e-3, 0.5, 2.5}) {
    for (const double L3 : {0.0, 0.7}) {
      const Problem p{top_with(0.6), {hanging.q, {push, 0, L3}}};
      expect_exact(fmt::format("pushed by {:g}", push), p, 10.0);
    }
  }
}

// I1: a rotator on a pivot is a spherical pendulum with five degrees of freedom less one
TEST(ExactHeavySymmetric, I1RotatorIsASphericalPendulum) {
  const BodyModel rod = heavy_body({1, 1, 0}, {0, 0, 1});
  for (const Vec3& y : {Vec3(0.5, 0.8, 0), Vec3(0, 0, 0), Vec3(0.01, 1.9, 0), Vec3(3.0, 0.1, 0)}) {
    for (const double tilt : {0.3, 1.5, 3.0}) {
      const Problem p{rod, {from_zxz_angles({0.2, tilt, 0.9}), y}};
      expect_exact(fmt::format("I1 tilt {}", tilt), p, 10.0);
      EXPECT_EQ(exact_heavy_symmetric(p.model, p.start)->at(3.0).y[2], 0.0);
    }
  }
  // a conical pendulum goes round at sqrt(mu / (A cos)), seen from below
  const double tilt = kPi - 0.5;
  const double rate = std::sqrt(1.0 / std::cos(0.5));
  const Problem p{rod, {from_zxz_angles({0, tilt, 0}), {0, rate * std::sin(tilt), 0}}};
  const Vec3 tip = exact_heavy_symmetric(p.model, p.start)->at(2.0 * kPi / rate).q * Vec3::UnitZ();
  EXPECT_LE((tip - p.start.q * Vec3::UnitZ()).norm(), 1e-14);
}

// swinging in a plane: period 4 K(sin(a/2)) / w0, and over the top beyond the separatrix
TEST(ExactHeavySymmetric, PlanarPendulum) {
  const BodyModel rod = heavy_body({1, 1, 0}, {0, 0, 1});
  const Problem swing{rod, {from_zxz_angles({0, kPi - kPi / 3, 0}), Vec3::Zero()}};
  // K(sin 30 deg), Abramowitz and Stegun 17.1
  const double period = 4.0 * 1.685750354812596;
  const auto exact = exact_heavy_symmetric(swing.model, swing.start);
  const auto lowest = [](const State& s) {
    return (s.q * Vec3::UnitZ()).z();
  };
  EXPECT_LE(rotation_angle_between(exact->at(period).q, swing.start.q), 4e-15);
  EXPECT_LE(exact->at(period).y.norm(), 4e-15);
  EXPECT_NEAR(lowest(exact->at(period / 4)), -1.0, 1e-15);
  for (const double y1 : {0.1, 1.9, 1.999999, 2.0, 2.000001, 2.5, 10.0}) {
    // pushed from below: 2 takes it just to the top
    const Problem p{rod, {Quat(0, 1, 0, 0), {y1, 0, 0}}};
    expect_exact(fmt::format("planar, push {}", y1), p, 10.0);
    const auto plane = exact_heavy_symmetric(p.model, p.start);
    for (int i = 0; i < 20; ++i)
      EXPECT_LE(std::abs((plane->at(0.5 * i).q * Vec3::UnitZ()).x()), 4e-15 * y1);
  }
}

// Bruels, Cardona, Arnold, Mech. Mach. Theory 48 (2012) 121: passes 5e-14 from the vertical
TEST(ExactHeavySymmetric, L2TopOfBruelsCardonaArnold) {
  const Problem p{
      heavy_body({15.234375, 0.46875, 15.234375}, {0, 147.15, 0}),
      {Quat::Identity(), Vec3(15.234375, 0.46875, 15.234375).cwiseProduct(Vec3(0, 150, -4.61538))}};
  expect_exact("L2, 2 s", p, 2.0);
}

TEST(ExactHeavySymmetric, FastTopsKeepTheirDigits) {
  for (const double spin : {1e2, 1e4, 1e6}) {
    const Problem p{top_with(0.6), {from_zxz_angles({0.3, 0.5, 0.7}), {0, 0, spin}}};
    expect_exact(fmt::format("spin {:g}, 100 rotations", spin), p, 100.0 * 2.0 * kPi * 0.6 / spin);
  }
}

TEST(ExactHeavySymmetric, WeakGravityJoinsTheFreeTop) {
  for (const double mu : {1e-2, 1e-6, 1e-10, 2e-13}) {
    const Problem p{top_with(0.6, mu), {kTilted, {0.5, -0.8, 1.1}}};
    expect_exact(fmt::format("mu = {:g}", mu), p, 10.0);
  }
}

}  // namespace
}  // namespace polhode
