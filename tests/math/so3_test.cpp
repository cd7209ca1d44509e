// SPDX-License-Identifier: MIT
#include "math/so3.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/units.h"
#include "support/residual.h"

namespace polhode {
namespace {

using test::expect_residual;
using test::worse;

Vec3 random_vector(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return size * Vec3(uniform(random), uniform(random), uniform(random));
}

TEST(ExpRotation, AgreesWithAxisAndAngleAtEverySize) {
  std::mt19937_64 random(1);
  double worst = 0.0;
  // sizes on both sides of the switch between sine and series at |v| = 2e-4
  for (const double size : {1e-12, 1e-5, 1.9e-4, 2.1e-4, 1e-2, 1.0, 3.0, 20.0}) {
    for (int i = 0; i < 50; ++i) {
      const Vec3 v = size * random_vector(random, 1.0).normalized();
      const long double half = 0.5L * std::sqrt((long double)v.squaredNorm());
      const Quat q = exp_rotation(v);
      const double sinc = static_cast<double>(std::sin(half) / half);
      worst = worse(worst, std::abs(q.w() - static_cast<double>(std::cos(half))));
      worst = worse(worst, (q.vec() - 0.5 * sinc * v).norm() / (1.0 + 0.5 * v.norm()));
    }
  }
  expect_residual("exp against sine and cosine", worst, 1e-15);  // measured 2e-16
  EXPECT_EQ(exp_rotation(Vec3::Zero()).coeffs(), Quat::Identity().coeffs());
}

TEST(ExpRotation, IsAOneParameterGroup) {
  std::mt19937_64 random(2);
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 v = random_vector(random, 3.0);
    const Quat split = exp_rotation(0.3 * v) * exp_rotation(0.7 * v);
    worst = worse(worst, (split.coeffs() - exp_rotation(v).coeffs()).norm());
  }
  expect_residual("exp(.3v) exp(.7v) = exp(v)", worst, 2e-15);  // measured 4e-16
}

TEST(RotationAngle, InvertsExp) {
  std::mt19937_64 random(3);
  for (const double angle : {1e-150, 1e-12, 1e-8, 1e-3, 1.0, 3.0, kPi}) {
    double worst = 0.0;
    for (int i = 0; i < 50; ++i) {
      const Vec3 v = angle * random_vector(random, 1.0).normalized();
      const double found = rotation_angle_between(Quat::Identity(), exp_rotation(v));
      worst = worse(worst, std::abs(found - angle) / angle);
    }
    expect_residual(fmt::format("angle {:g} read back", angle), worst, 1e-15);
  }
}

TEST(RotationAngle, KeepsDigitsOfTinyAnglesBetweenAnyAttitudes) {
  // between two stored attitudes only the round-off of storing them is lost, half a digit of 1
  std::mt19937_64 random(4);
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Quat a = exp_rotation(random_vector(random, 3.0));
    const Quat b = a * exp_rotation(1e-12 * random_vector(random, 1.0).normalized());
    worst = worse(worst, std::abs(rotation_angle_between(a, b) - 1e-12));
  }
  expect_residual("1e-12 rad between stored attitudes", worst, 1e-15);
}

TEST(RotationAngle, TakesTheShortWayAndIgnoresTheSignOfQ) {
  const Quat q = exp_rotation({0.0, 0.0, 5.0});
  EXPECT_NEAR(rotation_angle_between(Quat::Identity(), q), 2.0 * kPi - 5.0, 1e-15);
  EXPECT_EQ(rotation_angle_between(q, Quat(-q.coeffs())), 0.0);
}

TEST(AngleBetween, KeepsItsDigitsAtBothEnds) {
  const Vec3 a = 0.2 * Vec3::UnitX();
  for (const double angle : {0.0, 1e-150, 1e-12, 1e-3, 1.0, 3.0}) {
    const Vec3 b(5.0 * std::cos(angle), 5.0 * std::sin(angle), 0.0);
    EXPECT_NEAR(angle_between(a, b), angle, 1e-15 * angle);
    EXPECT_NEAR(angle_between(a, -b), kPi - angle, 1e-15);
  }
  EXPECT_EQ(angle_between(a, Vec3::Zero()), 0.0);
}

TEST(ZxzAngles, RoundTrip) {
  std::mt19937_64 random(5);
  double worst = 0.0;
  for (int i = 0; i < 500; ++i) {
    const Quat q = exp_rotation(random_vector(random, 3.0));
    const Vec3 angles = zxz_angles(q);
    EXPECT_GE(angles[1], 0.0);
    EXPECT_LE(angles[1], kPi);
    worst = worse(worst, rotation_angle_between(q, from_zxz_angles(angles)));
  }
  expect_residual("zxz there and back", worst, 4e-15);
}

TEST(ZxzAngles, RoundTripAtThePolesAndNextToThem) {
  double worst = 0.0;
  for (const double theta : {0.0, 1e-300, 1e-15, 1e-8, kPi / 2, kPi - 1e-8, kPi - 1e-15, kPi}) {
    for (const double phi : {-3.0, 0.0, 0.7}) {
      const Quat q = from_zxz_angles({phi, theta, 0.4});
      const Vec3 angles = zxz_angles(q);
      worst = worse(worst, rotation_angle_between(q, from_zxz_angles(angles)));
      worst = worse(worst, std::abs(angles[1] - theta));
    }
  }
  expect_residual("zxz near the poles", worst, 2e-15);

  // at the pole itself psi is zero by convention, and phi carries the whole turn
  const Vec3 angles = zxz_angles(from_zxz_angles({0.3, 0.0, 0.4}));
  EXPECT_EQ(angles[2], 0.0);
  EXPECT_NEAR(angles[0], 0.7, 1e-15);
  const Vec3 lower = zxz_angles(Quat(0.0, std::cos(0.2), std::sin(0.2), 0.0));
  EXPECT_EQ(lower[2], 0.0);
  EXPECT_NEAR(lower[0], 0.4, 1e-15);
  EXPECT_NEAR(lower[1], kPi, 1e-15);
}

TEST(ZxzAngles, MeanRzRxRz) {
  const Vec3 angles(0.3, 0.5, -0.8);
  const Mat3 R =
      (Eigen::AngleAxisd(angles[0], Vec3::UnitZ()) * Eigen::AngleAxisd(angles[1], Vec3::UnitX()) *
       Eigen::AngleAxisd(angles[2], Vec3::UnitZ()))
          .toRotationMatrix();
  EXPECT_LE((from_zxz_angles(angles).toRotationMatrix() - R).norm(), 1e-15);
  // theta is the tilt of the body's third axis
  EXPECT_NEAR((from_zxz_angles(angles) * Vec3::UnitZ()).z(), std::cos(0.5), 1e-16);
}

TEST(ZxzRates, AgreeWithFiniteDifferences) {
  const Vec3 rates(0.7, -1.3, 2.1);
  double worst = 0.0;
  for (const Vec3& angles : {Vec3(0.2, 0.9, -2.0), Vec3(3.0, 0.0, 1.0), Vec3(-1.0, kPi, 0.3)}) {
    // w = 2 q^-1 dq/dt, by a central difference of fourth order
    const auto q = [&](double t) {
      return from_zxz_angles(angles + t * rates).coeffs();
    };
    const double h = 1e-3;
    const Quat slope(Eigen::Vector4d((8.0 * (q(h) - q(-h)) - (q(2 * h) - q(-2 * h))) / (12.0 * h)));
    const Vec3 w = 2.0 * (from_zxz_angles(angles).conjugate() * slope).vec();
    worst = worse(worst, (w - body_rate_from_zxz_rates(angles, rates)).norm());
  }
  expect_residual("rates of zxz angles", worst, 1e-11);  // h^4 f'/30 = 1e-12
}

TEST(XyzTurns, TurnAboutXThenYThenZOfTheFixedAxes) {
  // x first: z goes to -y, which a turn about z by 90 degrees brings to x
  const Mat3 R = from_xyz_turns({kPi / 2, 0.0, kPi / 2});
  EXPECT_LE((R * Vec3::UnitZ() - Vec3::UnitX()).norm(), 1e-15);
  const Mat3 general = from_xyz_turns({0.1, 0.2, 0.3});
  const Mat3 expected =
      (Eigen::AngleAxisd(0.3, Vec3::UnitZ()) * Eigen::AngleAxisd(0.2, Vec3::UnitY()) *
       Eigen::AngleAxisd(0.1, Vec3::UnitX()))
          .toRotationMatrix();
  EXPECT_LE((general - expected).norm(), 1e-15);
}

TEST(Normalized, ScalesOnly) {
  const Quat q = normalized(Quat(3.0, 0.0, -4.0, 0.0));
  EXPECT_EQ(q.w(), 0.6);
  EXPECT_EQ(q.y(), -0.8);
}

// math/notation.h: adjacent letters cancel, rates in body axes multiply from the right
TEST(Notation, LettersCancel) {
  const Quat q_SB = exp_rotation({0.0, 0.0, kPi / 2});
  EXPECT_LE((q_SB * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);  // body x lies along space y
  EXPECT_LE((q_SB.toRotationMatrix() * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);

  const Quat q_BP = exp_rotation({0.3, 0.1, -0.7});
  const Vec3 v_P(0.2, -1.0, 0.4);
  EXPECT_LE(((q_SB * q_BP) * v_P - q_SB * (q_BP * v_P)).norm(), 1e-15);
  EXPECT_EQ(Quat(1.0, 2.0, 3.0, 4.0).w(), 1.0);  // written (w, x, y, z)
}

TEST(Notation, BodyRatesMultiplyFromTheRight) {
  const Quat q0 = exp_rotation({0.3, 0.1, -0.7});
  const Vec3 w(0.4, -0.2, 0.9);
  const double h = 1e-6;
  const Quat late = q0 * exp_rotation(h * w);
  const Eigen::Vector4d slope = (late.coeffs() - q0.coeffs()) / h;
  const Quat rate = Quat(0.5 * (q0 * Quat(0.0, w.x(), w.y(), w.z())).coeffs());
  EXPECT_LE((slope - rate.coeffs()).norm(), 1e-6);
}

}  // namespace
}  // namespace polhode
