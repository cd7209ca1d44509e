// SPDX-License-Identifier: MIT
// The closed form of the free asymmetric top (motion/exact/asymmetric.cpp).
#include <cmath>

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

double worst_until(const BodyModel& model, const State& start, double duration, int samples = 100) {
  const auto exact = exact_asymmetric(model, start);
  TaylorOracle oracle(model, start);
  double worst = 0.0;
  for (int i = 0; i <= samples; ++i) {
    const double t = duration * i / samples;
    worst = worse(worst, distance(exact->at(t), oracle.at(t)));
  }
  return worst;
}

const Vec3 kOrders[] = {{0.6, 0.8, 1.0},
                        {0.8, 1.0, 0.6},
                        {1.0, 0.6, 0.8},
                        {0.6, 1.0, 0.8},
                        {1.0, 0.8, 0.6},
                        {0.8, 0.6, 1.0}};

TEST(ExactAsymmetric, AgreesWithTheOracleInEveryOrderOfAxesAndEverySign) {
  double worst = 0.0;
  for (const Vec3& moments : kOrders) {
    const BodyModel model = free_body(moments);
    for (int signs = 0; signs < 8; ++signs) {
      for (const Vec3& size : {Vec3(1.8, 0.4, 0.9), Vec3(0.3, 0.4, 1.9), Vec3(0.2, 1.7, 0.3)}) {
        State start{exp_rotation({0.4, -1.3, 0.8}), size};
        for (int i = 0; i < 3; ++i)
          if (signs >> i & 1) start.y[i] = -start.y[i];
        worst = worse(worst, worst_until(model, start, 10.0, 40));
      }
    }
  }
  expect_residual("asymmetric, 144 starts, t = 10", worst, 2e-14);
}

TEST(ExactAsymmetric, ReachesTheHairerVilmartEndState) {
  const Problem p = hairer_vilmart();
  const State expected{Quat(-0.73606136416079393616,
                            -0.57078695124035073325,
                            -0.29938857183079009374,
                            -0.20683908610467319248),
                       Vec3(1.7659625085182075357, -0.6954641970330891195, 0.7795549814818710861)};
  expect_residual(
      "HV, t = 10", distance(exact_asymmetric(p.model, p.start)->at(10.0), expected), 2e-14);
}

TEST(ExactAsymmetric, AfterAThousandRotations) {
  const Problem p = hairer_vilmart();
  const double duration = 1000.0 * 2.0 * kPi * 0.8 / p.start.y.norm();
  expect_residual("asymmetric, 1000 rotations", worst_until(p.model, p.start, duration, 40), 3e-12);
}

TEST(ExactAsymmetric, RepeatsAfterItsPeriod) {
  const Problem p = hairer_vilmart();
  const auto exact = exact_asymmetric(p.model, p.start);
  const Vec3 back = exact->at(6.86261617805812).y;
  expect_residual("period of y", (back - p.start.y).norm(), 2e-14);
}

TEST(ExactAsymmetric, KeepsEveryInvariantToRoundOff) {
  for (const Vec3& y : {Vec3(1.8, 0.4, -0.9), Vec3(0.3, 0.4, 1.9), Vec3(1e-3, 2.0, 1e-3)}) {
    const BodyModel model = free_body({0.6, 0.8, 1.0});
    const State start{exp_rotation({0.4, -1.3, 0.8}), y};
    const auto exact = exact_asymmetric(model, start);
    DriftWatch watch(model, start);
    double off_sphere = 0.0;
    for (int i = 0; i <= 3000; ++i) {
      const State s = exact->at(1.7 * i);
      watch.look_at(s);
      off_sphere = worse(off_sphere, std::abs(s.q.norm() - 1.0));
    }
    expect_residual("energy", watch.worst().energy.value(), 3e-15);
    expect_residual("L in space", watch.worst().momentum.value(), 5e-15);
    expect_residual("|q|", off_sphere, 2e-15);
  }
}

// the two that come back differ in nothing but round-off: dq/dt = q o w / 2 with the w of y
TEST(ExactAsymmetric, AttitudeTurnsAtTheRateOfTheMomentum) {
  const Problem p = hairer_vilmart();
  const auto exact = exact_asymmetric(p.model, p.start);
  double worst = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.37 * i + 0.1, h = 1e-4;
    const Quat turn = exact->at(t - h).q.conjugate() * exact->at(t + h).q;
    const Vec3 w = turn.vec() / h;
    worst = worse(worst, (w - angular_velocity(p.model, exact->at(t).y)).norm());
  }
  expect_residual("w from q against w from y", worst, 1e-6);
}

TEST(ExactAsymmetric, RotationAboutEachPrincipalAxisIsUniform) {
  const BodyModel model = free_body({0.6, 0.8, 1.0});
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const State start{exp_rotation({0.4, -1.3, 0.8}), sign * 1.5 * Vec3::Unit(axis)};
      const auto exact = exact_asymmetric(model, start);
      const Quat expected = start.q * exp_rotation(20.0 * angular_velocity(model, start.y));
      EXPECT_LE(rotation_angle_between(exact->at(20.0).q, expected), 1e-14);
      EXPECT_LE((exact->at(20.0).y - start.y).norm(), 1e-15);
    }
  }
}

TEST(ExactAsymmetric, BodyAtRestStaysThere) {
  const State rest{exp_rotation({0.4, -1.3, 0.8}), Vec3::Zero()};
  EXPECT_TRUE(same_bits(exact_asymmetric(free_body({0.6, 0.8, 1.0}), rest)->at(5.0), rest));
}

// X1: nothing is lost as two moments become equal
TEST(ExactAsymmetric, X1NearlySymmetric) {
  for (const double eps : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 4.5e-16, 0.0}) {
    for (const Vec3& moments : {Vec3(1.0, 1.0 + eps, 2.0), Vec3(1.0, 2.0 - eps, 2.0)}) {
      for (const Vec3& y : {Vec3(0.8, 0.5, 0.9), Vec3(0.05, 1.2, 0.02)}) {
        const State start{exp_rotation({0.4, -1.3, 0.8}), y};
        expect_residual(fmt::format("X1 eps = {:g}, t = 50", eps),
                        worst_until(free_body(moments), start, 50.0, 20),
                        6e-14);
      }
    }
  }
}

// X2: nor as all three do
TEST(ExactAsymmetric, X2NearlySpherical) {
  for (const double eps : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14}) {
    const State start{exp_rotation({0.4, -1.3, 0.8}), {0.8, 0.5, 0.9}};
    expect_residual(fmt::format("X2 eps = {:g}, t = 50", eps),
                    worst_until(free_body({1.0, 1.0 + eps, 1.0 + 2.5 * eps}), start, 50.0, 20),
                    6e-14);
  }
}

// X3: starts with y1 = 0 or y3 = 0, where the branch of an arctangent would turn the body by pi
TEST(ExactAsymmetric, X3StartsInAPrincipalPlane) {
  for (const Vec3& y : {Vec3(0.0, 0.9, 1.1),
                        Vec3(0.0, 1.9, 0.01),
                        Vec3(1.1, 0.9, 0.0),
                        Vec3(1.1, 0.0, 0.9),
                        Vec3(0.0, -0.9, -1.1),
                        Vec3(-0.0, 0.0, 1.0)}) {
    const State start{exp_rotation({0.4, -1.3, 0.8}), y};
    const BodyModel model = free_body({0.6, 0.8, 1.0});
    expect_residual("X3", worst_until(model, start, 10.0), 2e-14);
    const auto exact = exact_asymmetric(model, start);
    EXPECT_LE(distance(exact->at(0.0), start), 1e-15);
  }
}

// a start on the separatrix exactly in doubles: I = (2, 3, 6), y1^2 = y3^2
Problem separatrix(double s1, double s2, double s3) {
  return {free_body({2, 3, 6}), {exp_rotation({0.4, -1.3, 0.8}), {s1, 1.5 * s2, s3}}};
}

// growth of a small deviation over t seconds, off axis 2
double growth(const BodyModel& model, const State& start, double t) {
  const double I1 = model.moments[0], I2 = model.moments[1], I3 = model.moments[2];
  return std::exp(start.y.norm() / I2 * std::sqrt((I2 - I1) * (I3 - I2) / (I1 * I3)) * t);
}

TEST(ExactAsymmetric, X4NearTheSeparatrix) {
  for (const double off : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 4e-16}) {
    for (const double sign : {1.0, -1.0}) {
      Problem p = separatrix(1, 1, -1);
      p.start.y[0] += sign * off;
      const double duration = 30.0;
      // theory allows the round-off of the start times the transient growth, 1.5e-11 here
      EXPECT_GT(growth(p.model, p.start, duration), 1e4);
      expect_residual(fmt::format("X4 excess {:g}", sign * off),
                      worst_until(p.model, p.start, duration),
                      3e-13);
      const auto exact = exact_asymmetric(p.model, p.start);
      DriftWatch watch(p.model, p.start);
      for (int i = 0; i < 1000; ++i)
        watch.look_at(exact->at(0.37 * i));
      expect_residual("  invariants",
                      std::hypot(watch.worst().energy.value(), watch.worst().momentum.value()),
                      4e-15);
    }
  }
}

TEST(ExactAsymmetric, X5TheSeparatrixItselfJoinsBothSides) {
  for (int signs = 0; signs < 8; ++signs) {
    const auto sign = [&](int i) {
      return (signs >> i & 1) != 0 ? -1.0 : 1.0;
    };
    const Problem p = separatrix(sign(0), sign(1), sign(2));
    const double duration = 20.0;
    expect_residual("X5 on the separatrix", worst_until(p.model, p.start, duration), 5e-15);
    const auto exact = exact_asymmetric(p.model, p.start);
    for (const double off : {1e-12, -1e-12}) {
      Problem beside = p;
      beside.start.y[0] *= 1.0 + off;
      const auto other = exact_asymmetric(beside.model, beside.start);
      for (int i = 0; i <= 20; ++i)
        EXPECT_LE(distance(other->at(i), exact->at(i)), 4e-12 * growth(p.model, p.start, i));
    }
  }
}

// near axis 2: the flip time 2 K / |lambda| = (2 / sigma) ln(4 / sqrt m1) of the tennis racket
TEST(ExactAsymmetric, TennisRacketFlips) {
  for (const double off : {1e-3, 1e-6, 1e-9}) {
    const Problem p{free_body({0.6, 0.8, 1.0}), {Quat::Identity(), {off, 1.5, 0.0}}};
    const auto exact = exact_asymmetric(p.model, p.start);
    const double sigma = std::log(growth(p.model, p.start, 1.0));
    // half way through the flip y2 = 0; y grows from `off` to its largest as e^(sigma t)
    double from = 0.0, to = 2.0 * std::log(10.0 / off) / sigma;
    ASSERT_LT(exact->at(to).y[1], 0.0);
    while (to - from > 1e-12) {
      const double middle = 0.5 * (from + to);
      (exact->at(middle).y[1] > 0.0 ? from : to) = middle;
    }
    // m1 = excess2 (I3 - I1) / (excess1 (I3 - I2)) up to signs, here
    const double excess2 = off * off * (0.8 - 0.6) / 0.6;
    const double excess3 = off * off * (1.0 - 0.6) / 0.6 + 2.25 * (1.0 - 0.8) / 0.8;
    const double m1 = excess2 * (1.0 - 0.6) / (excess3 * (0.8 - 0.6));
    EXPECT_NEAR(from * sigma, std::log(4.0 / std::sqrt(m1)), 2.0 * off);
  }
}

}  // namespace
}  // namespace polhode
