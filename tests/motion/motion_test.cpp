// SPDX-License-Identifier: MIT
#include "motion/motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "motion/simulate.h"
#include "support/expect_error.h"
#include "support/on_table.h"
#include "support/residual.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;

// a body whose principal axes are not the axes of the scene file
BodySpec skew_body() {
  const Mat3 turn = exp_rotation({0.7, -1.2, 0.4}).toRotationMatrix();
  const Mat3 tensor = turn * Vec3(0.6, 0.8, 1.0).asDiagonal() * turn.transpose();
  BodySpec spec;
  spec.tensor = 0.5 * (tensor + tensor.transpose());
  spec.mass = 2.0;
  spec.center_of_mass = Vec3(0.1, 0.2, -0.3);
  return spec;
}

Motion motion_of(const BodySpec& body, const MotionSpec& spec) {
  const BodyModel model = make_model(body, spec);
  return simulate(model, spec, {}, 1e-9).motion;
}

TEST(StartState, EverySpinMeansTheSameRotation) {
  const BodyModel model = make_model(skew_body(), false, Vec3::Zero());
  MotionSpec spec;
  spec.attitude.zxz = Vec3(0.3, 0.9, -0.5);
  const Quat q_SB = from_zxz_angles(*spec.attitude.zxz);
  spec.spin.rates = Vec3(1.0, -0.4, 2.0);
  const Vec3 w_B = body_rate_from_zxz_rates(*spec.attitude.zxz, *spec.spin.rates);
  const State expected = start_state(model, spec);
  EXPECT_LE((model.R_BP * angular_velocity(model, expected.y) - w_B).norm(), 2e-15);
  EXPECT_LE(rotation_angle_between(expected.q * Quat(model.R_BP).conjugate(), q_SB), 1e-15);

  spec.spin = {};
  spec.spin.body = w_B;
  EXPECT_LE(distance(start_state(model, spec), expected), 1e-15);
  spec.spin = {};
  spec.spin.space = q_SB * w_B;
  EXPECT_LE(distance(start_state(model, spec), expected), 1e-15);
  spec.spin = {};
  spec.spin.momentum_body = *skew_body().tensor * w_B;
  EXPECT_LE(distance(start_state(model, spec), expected), 1e-14);

  // the same attitude as a quaternion of any length
  const Quat scaled = Quat(3.0 * q_SB.coeffs());
  spec.attitude = {};
  spec.attitude.quaternion = Eigen::Vector4d(scaled.w(), scaled.x(), scaled.y(), scaled.z());
  EXPECT_LE(distance(start_state(model, spec), expected), 1e-14);
  spec.spin = {};
  EXPECT_EQ(start_state(model, spec).y, Vec3(Vec3::Zero()));
}

TEST(StartState, ARotatorIsNotSpunAboutItsLine) {
  BodySpec rod;
  rod.points = {{1.0, {1, 2, 2}}, {1.0, {-1, -2, -2}}};
  const BodyModel model = make_model(rod, false, Vec3::Zero());
  MotionSpec spec;
  spec.spin.body = Vec3(1, 2, 3);
  expect_input_error([&] { start_state(model, spec); }, "motion.spin", "on a line");
  spec.spin = {};
  spec.spin.momentum_body = Vec3(1, 2, 2);
  expect_input_error([&] { start_state(model, spec); }, "motion.spin", "on a line");
  spec.spin = {};
  spec.spin.body = Vec3(0, 1, -1);
  EXPECT_NEAR(start_state(model, spec).y.norm(), 18.0 * std::sqrt(2.0), 1e-13);
}

TEST(Gravity, DefaultsFollowTheHold) {
  MotionSpec spec;
  EXPECT_EQ(gravity_of(spec), Vec3(0, 0, 0));
  spec.hold = "pivot";
  EXPECT_EQ(gravity_of(spec), Vec3(0, 0, -9.80665));
  spec.gravity = Vec3(0, -1.62, 0);
  EXPECT_EQ(gravity_of(spec), Vec3(0, -1.62, 0));
}

TEST(Sample, AllQuantitiesAgree) {
  MotionSpec spec;
  spec.spin.body = Vec3(1.0, -2.0, 0.5);
  spec.duration = 3.0;
  const BodySpec body = skew_body();
  const Motion motion = motion_of(body, spec);
  const Sample start = motion.at(0.0);
  EXPECT_LE((start.w_B - *spec.spin.body).norm(), 2e-15);
  EXPECT_LE(rotation_angle_between(start.q_SB, Quat::Identity()), 1e-15);
  for (const double t : {0.0, 0.7, 3.0}) {
    const Sample s = motion.at(t);
    EXPECT_EQ(s.t, t);
    EXPECT_LE((s.w_S - s.q_SB * s.w_B).norm(), 4e-15);
    EXPECT_LE((s.L_S - s.q_SB * (*body.tensor * s.w_B)).norm(), 4e-15);
    EXPECT_LE((s.L_S - start.L_S).norm(), 1e-9);
    EXPECT_NEAR(s.energy, 0.5 * s.w_S.dot(s.L_S), 4e-15);
  }

  // w is the rate of turning of the attitude that is shown
  const double h = 1e-5;
  const Quat turn = motion.at(1.0 - h).q_SB.conjugate() * motion.at(1.0 + h).q_SB;
  EXPECT_LE((turn.vec() / h - motion.at(1.0).w_B).norm(), 1e-8);
}

TEST(FreeFlight, IsAParabolaWithConstantEnergy) {
  MotionSpec spec;
  spec.gravity = Vec3(0, 0, -9.81);
  spec.position = Vec3(1, 2, 3);
  spec.velocity = Vec3(4, 0, 5);
  spec.spin.body = Vec3(1.0, -2.0, 0.5);
  const Motion motion = motion_of(skew_body(), spec);
  const Sample s = motion.at(2.0);
  EXPECT_LE((s.center_S - Vec3(9.0, 2.0, 3.0 + 10.0 - 2.0 * 9.81)).norm(), 1e-14);
  EXPECT_EQ(s.reference_S, s.center_S);
  const double rotation = 0.5 * s.w_S.dot(s.L_S);
  EXPECT_NEAR(motion.at(0.0).energy, rotation + 41.0 + 2.0 * 9.81 * 3.0, 1e-8);
  for (const double t : {0.5, 2.0, 10.0})
    EXPECT_NEAR(motion.at(t).energy, motion.at(0.0).energy, 1e-8);
}

// V + Omega x r against central differences of the position, flying and held
TEST(PointVelocity, IsTheRateOfThePosition) {
  for (const char* hold : {"free", "pivot"}) {
    MotionSpec spec;
    spec.hold = hold;
    spec.gravity = Vec3(0.3, 0, -9.81);
    spec.attitude.zxz = Vec3(0.3, 0.9, -0.5);
    spec.spin.body = Vec3(1.0, -2.0, 0.5);
    spec.duration = 2.0;
    if (spec.hold == "free") spec.velocity = Vec3(4, 0, 5);
    BodySpec body = skew_body();
    body.pivot = Vec3(0.2, -0.1, 0.4);
    const Motion motion = motion_of(body, spec);
    const BodyModel& model = motion.model();
    for (const double t : {0.4, 1.3}) {
      for (const Vec3& r : {Vec3(0, 0, 0), Vec3(0.5, -0.3, 0.8), body.pivot}) {
        const double h = 1e-4;
        const Vec3 rate = (point_position(model, motion.at(t + h), r) -
                           point_position(model, motion.at(t - h), r)) /
                          (2.0 * h);
        expect_residual("point velocity, " + spec.hold,
                        (point_velocity(model, motion.at(t), r) - rate).norm(),
                        2e-6);
      }
      // the centre of mass has the velocity of the parabola, the pivot none
      const Sample s = motion.at(t);
      const Vec3 reference = point_velocity(model, s, model.reference_B());
      const Vec3 expected =
          spec.hold == "free" ? Vec3(spec.velocity + t * *spec.gravity) : Vec3(Vec3::Zero());
      EXPECT_LE((reference - expected).norm(), 4e-15);
    }
  }
}

// a rod let go at rest: swings with the period of the compound pendulum, 4 K(sin(a/2)) / w0
TEST(Pendulum, StartsAtRestAndSwingsWithItsPeriod) {
  BodySpec body;
  SolidSpec rod;
  rod.kind = "rod";
  rod.mass = 0.3;
  rod.length = 1.2;
  body.solid = rod;
  body.pivot = Vec3(0, 0, 0.6);
  MotionSpec spec;
  spec.hold = "pivot";
  spec.attitude.zxz = Vec3(0, kPi / 3, 0);
  spec.duration = 5.0;
  const Motion motion = motion_of(body, spec);
  EXPECT_LE(motion.at(0.0).w_S.norm(), 1e-15);
  EXPECT_LE(motion.at(1.0).reference_S.norm(), 0.0);

  // w0^2 = m g d / I = 3 g / 2 l; K(sin 30 deg) = 1.685750354812596 (Abramowitz and Stegun 17.1)
  const double w0 = std::sqrt(1.5 * 9.80665 / 1.2);
  const double period = 4.0 * 1.685750354812596 / w0;
  EXPECT_LE((motion.at(period).center_S - motion.at(0.0).center_S).norm(), 4e-15);
  EXPECT_LE(
      (motion.at(period / 2).center_S - Vec3(0, -1, 1).cwiseProduct(motion.at(0).center_S)).norm(),
      4e-15);
  EXPECT_NEAR(motion.at(period / 4).center_S.z(), -0.6, 4e-15);
  for (const double t : {0.3, 1.0, 4.9})
    EXPECT_NEAR(motion.at(t).energy, motion.at(0.0).energy, 1e-14);
}

// on a table with what that does, in flight too: the rate of the angular momentum
TEST(Motion, TorqueChangesTheAngularMomentum) {
  MotionSpec spec = on_table(0.6, rolling());
  spec.attitude.zxz = Vec3(0.0, 0.9, 0.4);
  spec.spin.body = Vec3(1.0, 3.0, 5.0);
  BodySpec body;
  body.solid = SolidSpec{};
  body.solid->kind = "ellipsoid";
  body.solid->semi_axes = Vec3(0.1, 0.06, 0.05);
  body.solid->mass = 1.0;
  const Motion motion = simulate(make_model(body, spec), spec, {}, 1e-9).motion;
  constexpr double kStep = 1e-4;
  for (const double t : {0.1, 0.3, 0.5}) {
    const Vec3 rate = (motion.at(t + kStep).L_S - motion.at(t - kStep).L_S) / (2.0 * kStep);
    const std::optional<Vec3> torque_S = torque_at(motion, t);
    ASSERT_TRUE(torque_S);
    EXPECT_GT(rate.norm(), 0.05);
    EXPECT_LT((*torque_S - rate).norm(), 1e-4 * rate.norm()) << t;
  }
  NumericsSpec coarse;
  coarse.method = "table_euler";
  coarse.step = 1e-3;
  EXPECT_FALSE(torque_at(simulate(make_model(body, spec), spec, coarse, 1.0).motion, 0.1))
      << "it does not tell what touches";
}

}  // namespace
}  // namespace polhode
