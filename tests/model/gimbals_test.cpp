// SPDX-License-Identifier: MIT
#include "model/gimbals.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "math/so3.h"

namespace polhode {
namespace {

using Real = long double;
using Vec3L = Eigen::Matrix<Real, 3, 1>;
using Mat3L = Eigen::Matrix<Real, 3, 3>;

// a rotor in rings, with everything that can act between them
struct Rig {
  Vec3 moments;  // of the rotor, about x, y and the axle z
  Gimbals gimbals;
};

Mat3L turn(int axis, Real angle) {
  const Vec3L unit = Vec3L::Unit(axis);
  return Eigen::AngleAxis<Real>(angle, unit).toRotationMatrix();
}

// Kinetic energy against the stars at the angles (phi, theta, psi) and their rates, from the
// rotations of the three bodies alone.
Real lagrangian(const Rig& rig, const Vec3L& angles, const Vec3L& rates) {
  const Vec3L frame = rig.gimbals.frame_S.cast<Real>();
  const Mat3L outer = turn(2, angles[0]);
  const Mat3L inner = outer * turn(0, angles[1]);
  const Mat3L rotor = inner * turn(2, angles[2]);
  const Vec3L of_outer = frame + rates[0] * Vec3L::UnitZ();
  const Vec3L of_inner = of_outer + rates[1] * outer.col(0);
  const Vec3L of_rotor = of_inner + rates[2] * inner.col(2);
  const auto energy = [](const Mat3L& body, const Vec3& moments, const Vec3L& w) -> Real {
    const Vec3L seen = body.transpose() * w;
    return Real(0.5) * seen.dot(moments.cast<Real>().cwiseProduct(seen));
  };
  // the outer ring's moments across the vertical add a constant
  return energy(outer, Vec3(0.0, 0.0, rig.gimbals.outer), of_outer) +
         energy(inner, rig.gimbals.inner, of_inner) + energy(rotor, rig.moments, of_rotor);
}

// The accelerations of the angles by Lagrange's equations, with derivatives as differences.
Vec3L lagrange(const Rig& rig, const Vec3L& angles, const Vec3L& rates) {
  const Real h = 1e-4L;
  const auto d_rate = [&](int i, const Vec3L& at, const Vec3L& moving) -> Real {
    const Vec3L step = h * Vec3L::Unit(i);
    // quadratic in the rates, so that this difference is exact
    return (lagrangian(rig, at, moving + step) - lagrangian(rig, at, moving - step)) / (2 * h);
  };
  // of order 6
  const auto difference = [&](const auto& f) -> decltype(f(Real(0))) {
    return ((f(h) - f(-h)) * Real(45) - (f(2 * h) - f(-2 * h)) * Real(9) + (f(3 * h) - f(-3 * h))) /
           (60 * h);
  };
  Mat3L mass;
  Vec3L right;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      mass(i, j) = (d_rate(i, angles, rates + h * Vec3L::Unit(j)) -
                    d_rate(i, angles, rates - h * Vec3L::Unit(j))) /
                   (2 * h);
    }
    right[i] = difference(
        [&](Real e) -> Real { return lagrangian(rig, angles + e * Vec3L::Unit(i), rates); });
    right[i] -= difference([&](Real e) -> Real { return d_rate(i, angles + e * rates, rates); });
    right[i] -= Real(rig.gimbals.friction[i]) * rates[i];
  }
  // what is held does not accelerate; its equation has an unknown torque
  const int held = rig.gimbals.clamp == Gimbals::Clamp::outer   ? 0
                   : rig.gimbals.clamp == Gimbals::Clamp::inner ? 1
                                                                : -1;
  if (held >= 0) {
    mass.row(held) = Vec3L::Unit(held).transpose();
    right[held] = 0;
  }
  return mass.partialPivLu().solve(right);
}

Vec3 on_rotor(const Rig& rig, const GimbalPose& pose) {
  const Vec3 w = angular_velocity_of(rig.gimbals, pose);
  const Quat q = attitude_of(rig.gimbals, pose.angles);
  return frame_torque(rig.moments, w, q.conjugate() * rig.gimbals.frame_S);
}

TEST(Gimbals, MoveAsLagrangesEquationsSay) {
  std::mt19937 numbers(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(numbers);
  };
  const auto any = [&](double low, double high) -> Vec3 {
    return {between(low, high), between(low, high), between(low, high)};
  };
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Rig rig{any(0.5, 1.0), {}};
    rig.gimbals.outer = between(0.0, 2.0);
    rig.gimbals.inner = any(0.0, 1.0);
    rig.gimbals.friction = any(0.0, 1.0);
    rig.gimbals.frame_S = any(-2.0, 2.0);
    Vec3 rates = any(-3.0, 3.0);
    if (i % 3 == 1) {
      rig.gimbals.clamp = Gimbals::Clamp::outer;
      rates[0] = 0.0;
    } else if (i % 3 == 2) {
      rig.gimbals.clamp = Gimbals::Clamp::inner;
      rates[1] = 0.0;
    }
    const Vec3 angles(between(-3.0, 3.0), between(0.2, 2.9), between(-3.0, 3.0));
    const Vec3 truth = lagrange(rig, angles.cast<Real>(), rates.cast<Real>()).cast<double>();
    const GimbalPose pose{angles, rates};
    const Vec3 others = on_rotor(rig, pose);
    const Vec3 found = accelerations(rig.gimbals, pose, rig.moments, others);
    EXPECT_LT((found - truth).norm(), 1e-9 * (1.0 + truth.norm()));
  }
}

// the torque on the rotor is what bends its motion from that of a rotor without rings
TEST(Gimbals, TorqueIsWhatTheRotorFeels) {
  const Rig rig{{1.0, 0.8, 0.6}, {Mat3::Identity(), Mat3::Identity(), 0.7, {0.2, 0.3, 0.4}}};
  const GimbalPose pose{{0.4, 0.9, -1.2}, {2.0, -0.6, 3.0}};
  const Vec3 others(0.1, -0.2, 0.3);
  const Vec3 torque = torque_of_rings(rig.gimbals, pose, rig.moments, others);
  const Vec3 bend = accelerations(rig.gimbals, pose, rig.moments, others);
  const double h = 1e-5;
  const auto w = [&](double t) {
    const GimbalPose then{pose.angles + t * pose.rates + 0.5 * t * t * bend, pose.rates + t * bend};
    return angular_velocity_of(rig.gimbals, then);
  };
  const Vec3 now = w(0.0);
  const Vec3 y = rig.moments.cwiseProduct(now);
  const Vec3 felt = rig.moments.cwiseProduct((w(h) - w(-h)) / (2 * h)) - y.cross(now) - others;
  EXPECT_LT((torque - felt).norm(), 1e-8);
  EXPECT_LT(std::abs(torque.z()), 1e-14) << "bearings without friction turn nothing about the axle";
}

TEST(Gimbals, PoseIsThatOfTheEulerAngles) {
  Gimbals gimbals;
  gimbals.axes_P = exp_rotation({0.4, -0.2, 0.9}).toRotationMatrix();
  gimbals.axes_S = exp_rotation({-0.6, 0.5, 0.1}).toRotationMatrix();
  for (const double tilt : {1.1, -1.1, 2e-3, -2e-3}) {
    const GimbalPose pose{{0.7, tilt, -0.4}, {2.0, -0.6, 5.0}};
    const Quat q = attitude_of(gimbals, pose.angles);
    const Vec3 w = angular_velocity_of(gimbals, pose);
    const GimbalPose found = pose_of(gimbals, q, w, 0.5);
    EXPECT_LT((found.angles - pose.angles).norm(), 1e-12) << tilt;
    EXPECT_LT((found.rates - pose.rates).norm(), 1e-10) << tilt;
  }
  const GimbalPose plain{{0.7, 1.1, -0.4}, {2.0, -0.6, 5.0}};
  EXPECT_LT(
      (angular_velocity_of({}, plain) - body_rate_from_zxz_rates(plain.angles, plain.rates)).norm(),
      1e-15);
  EXPECT_LT(attitude_of({}, plain.angles).angularDistance(from_zxz_angles(plain.angles)), 1e-15);
}

TEST(Gimbals, WithoutMassTheyExertNothing) {
  const GimbalPose pose{{0.4, 0.9, -1.2}, {2.0, -0.6, 3.0}};
  const Vec3 torque = torque_of_rings({}, pose, Vec3(1.0, 0.8, 0.6), Vec3(0.1, 0.4, -0.3));
  EXPECT_LT(torque.norm(), 1e-14);
  EXPECT_TRUE(Gimbals{}.idle());
}

}  // namespace
}  // namespace polhode
