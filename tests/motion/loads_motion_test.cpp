// SPDX-License-Identifier: MIT
// Motions under torques and forces, against closed forms.
#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "math/so3.h"
#include "motion/simulate.h"
#include "motion/stepper_table.h"
#include "support/expect_error.h"
#include "support/loads.h"
#include "support/motions.h"
#include "support/residual.h"

namespace polhode {
namespace {

using test::body_with;
using test::expect_input_error;
using test::expect_residual;
using test::load;
using test::solved;
using test::spun;

double turn_between(const Sample& a, const Sample& b) {
  return rotation_angle_between(a.q_SB, b.q_SB);
}

// a constant torque that acts from one time to another, s
LoadSpec constant_between(double from, double until, std::optional<double> ramp = {}) {
  LoadSpec spec = load("constant");
  spec.from = from;
  spec.until = until;
  spec.ramp = ramp;
  return spec;
}

TEST(Torque, InSpaceChangesMomentumLinearly) {
  MotionSpec spec = spun({0.4, -0.1, 1.0});
  spec.torque = {load("constant")};
  spec.torque[0].space = Vec3(0.3, 0.2, -0.5);
  for (const Vec3& moments : {Vec3(1, 1, 1), Vec3(1, 1, 1.6), Vec3(1, 1.3, 1.7)}) {
    const Simulation s = solved(body_with(moments), spec);
    EXPECT_EQ(s.report.model, "ode");
    EXPECT_FALSE(s.report.record.drift.energy.has_value());
    EXPECT_FALSE(s.report.record.drift.momentum.has_value());
    const Vec3 L = s.motion.at(0.0).L_S;
    for (const double t : {1.3, 4.0}) {
      const Vec3 wanted = L + t * *spec.torque[0].space;
      expect_residual("L0 + tau t", (s.motion.at(t).L_S - wanted).norm(), 2e-11);
    }
  }
}

TEST(Torque, AboutAPrincipalAxisSpinsUp) {
  MotionSpec spec = spun({0, 0, 0.5});
  spec.torque = {load("constant")};
  spec.torque[0].body = Vec3(0, 0, 0.8);
  const Motion motion = solved(body_with({1, 1.3, 1.6}), spec).motion;
  for (const double t : {1.0, 3.7}) {
    const double angle = 0.5 * t + 0.5 * 0.8 / 1.6 * t * t;
    const Quat wanted = motion.at(0.0).q_SB * exp_rotation({0, 0, angle});
    expect_residual("half tau t^2 / I", rotation_angle_between(motion.at(t).q_SB, wanted), 1e-11);
    expect_residual("omega", std::abs(motion.at(t).w_B.z() - 0.5 - 0.5 * t), 1e-11);
  }
}

TEST(Torque, HarmonicOneSwingsTheSpin) {
  MotionSpec spec = spun({0, 0, 0});
  spec.torque = {load("constant")};
  spec.torque[0].body = Vec3(0, 0.8, 0);
  spec.torque[0].rate = 5.0;
  spec.torque[0].phase = 0.3;
  const Motion motion = solved(body_with({1, 1.3, 1.6}), spec).motion;
  for (const double t : {0.7, 3.9}) {
    const double spin = 0.8 / 1.3 / 5.0 * (std::sin(5.0 * t + 0.3) - std::sin(0.3));
    expect_residual("sine", std::abs(motion.at(t).w_B.y() - spin), 1e-11);
  }
}

// the angle is the double integral of a trapezoid: from 1 to 1.5 it rises, from 3 to 3.5 it falls
TEST(Torque, SwitchedWithARampSpinsUp) {
  MotionSpec spec = spun({0, 0, 0.5}, 6.0);
  spec.torque = {constant_between(1.0, 3.0, 0.5)};
  spec.torque[0].body = Vec3(0, 0, 0.8);
  const Simulation s = solved(body_with({1, 1.3, 1.6}), spec);
  EXPECT_TRUE(find_stepper(s.report.method).adaptive);
  EXPECT_TRUE(s.report.reliability.doubts.empty());
  // integrals of the ramp r(t) = clamp((t - a) / 0.5): once and twice
  const auto once = [](double a, double t) {
    const double u = std::clamp(t - a, 0.0, 0.5);
    return u * u + std::max(0.0, t - a - 0.5);
  };
  const auto twice = [](double a, double t) {
    const double u = std::clamp(t - a, 0.0, 0.5), after = std::max(0.0, t - a - 0.5);
    return u * u * u / 3.0 + 0.25 * after + 0.5 * after * after;
  };
  for (const double t : {0.9, 1.2, 2.0, 3.3, 6.0}) {
    const double spin = 0.5 + 0.5 * (once(1.0, t) - once(3.0, t));
    const double angle = 0.5 * t + 0.5 * (twice(1.0, t) - twice(3.0, t));
    const Quat wanted = s.motion.at(0.0).q_SB * exp_rotation({0, 0, angle});
    expect_residual("omega", std::abs(s.motion.at(t).w_B.z() - spin), 1e-11);
    expect_residual("angle", rotation_angle_between(s.motion.at(t).q_SB, wanted), 1e-11);
  }
}

// A torque that jumps on and off, on an asymmetric body: before it the closed form, while it acts
// the motion of a torque that always acts, after it the closed form of what it left.
TEST(Torque, ThatJumpsJoinsThreeMotions) {
  const BodySpec body = body_with({1, 1.3, 1.7});
  MotionSpec spec = spun({0.4, -0.1, 1.0}, 5.0);
  spec.torque = {constant_between(1.3, 1.7)};
  spec.torque[0].space = Vec3(0.9, 0.2, -0.5);
  const Motion switched = solved(body, spec).motion;

  const auto from_state = [&](const Sample& at, bool pushed, double duration) {
    MotionSpec next = spun(at.w_B, duration);
    next.attitude = {};
    next.attitude.quaternion = Eigen::Vector4d(at.q_SB.w(), at.q_SB.x(), at.q_SB.y(), at.q_SB.z());
    if (pushed) {
      next.torque = {load("constant")};
      next.torque[0].space = spec.torque[0].space;
    }
    return solved(body, next).motion;
  };
  const Motion before = from_state(switched.at(0.0), false, 1.3);
  const Motion during = from_state(before.at(1.3), true, 0.4);
  const Motion after = from_state(during.at(0.4), false, 3.3);
  expect_residual("before", turn_between(switched.at(1.2), before.at(1.2)), 1e-11);
  expect_residual("during", turn_between(switched.at(1.6), during.at(0.3)), 1e-11);
  expect_residual("after", turn_between(switched.at(5.0), after.at(3.3)), 1e-11);
}

// Where a strong torque begins, steps as long as before are so long that their errors are no
// numbers; they are shortened.
TEST(Torque, ThatBeginsStronglyShortensLongSteps) {
  const BodySpec body = body_with({0.01, 0.01, 0.005});
  for (const double strength : {700.0, 1e3, 3e4, 1e6}) {
    MotionSpec spec = spun({1.0, 0.0, 20.0}, 1.01);
    spec.torque = {load("constant")};
    spec.torque[0].from = 1.0;
    spec.torque[0].space = Vec3(0.0, 0.0, strength);
    const auto by = [&](const char* method) {
      NumericsSpec numerics;
      numerics.method = method;
      numerics.tolerance = 1e-9;
      return simulate(make_model(body, spec), spec, numerics, 1e-6).motion;
    };
    const Motion one = by("dop853"), other = by("dopri5");
    expect_residual("two methods", turn_between(one.at(1.005), other.at(1.005)), 1e-5);
  }
}

// a push in space on a free body leaves it with the momentum of force times time
TEST(Force, SwitchedPushesForItsTime) {
  MotionSpec spec = spun({0.4, -0.1, 1.0}, 4.0);
  spec.torque = {load("force")};
  spec.torque[0].space = Vec3(3.0, 0, 0);
  spec.torque[0].from = 1.0;
  spec.torque[0].until = 1.5;
  const BodySpec body = body_with({1, 1.3, 1.7});
  const Motion motion = solved(body, spec).motion;
  const double mass = motion.model().body.mass;
  const Vec3 there = motion.at(0.0).center_S;
  expect_residual("still", (motion.at(1.0).center_S - there).norm(), 1e-11);
  const double way = 3.0 / mass * (0.5 * 0.25 + 0.5 * 2.5);
  expect_residual("way", (motion.at(4.0).center_S - there - Vec3(way, 0, 0)).norm(), 1e-11);
}

// beside the centre by a rounding, a force turns a body at rest by nothing and still moves it
TEST(Force, ThatIsSwitchedOnMovesABodyAtRest) {
  MotionSpec spec;
  spec.duration = 3.0;
  spec.torque = {load("force")};
  spec.torque[0].space = Vec3(0, 0, 1000);
  spec.torque[0].from = 1.0;
  spec.torque[0].at = Vec3(0, 3e-18, 0);
  const Motion motion = solved(body_with({1, 1.3, 1.7}), spec).motion;
  const double mass = motion.model().body.mass;
  const Vec3 way = motion.at(3.0).center_S - motion.at(0.0).center_S;
  EXPECT_NEAR(way.z() * mass / 2000.0, 1.0, 1e-11);
}

// a satellite in an orbit of angular velocity 1: x away from the Earth, y ahead, z the orbit's
// normal
MotionSpec in_orbit(double duration) {
  MotionSpec spec;
  spec.duration = duration;
  spec.spin.body = Vec3(0, 0, 1);
  spec.torque = {load("gravity_gradient")};
  spec.torque[0].rate = 1.0;
  return spec;
}

// In the plane of the orbit the angle to the local vertical obeys theta'' = -(3/2) (Iy - Ix)/Iz
// sin(2 theta) (Hughes, Spacecraft Attitude Dynamics, section 9.1): a pendulum of twice the angle.
TEST(GravityGradient, LibratesAsAPendulum) {
  const Vec3 moments(1.0, 1.7, 2.0);
  const double w = std::sqrt(3.0 * (moments[1] - moments[0]) / moments[2]);
  for (const double amplitude : {1e-3, 0.5, 1.2}) {
    const double period = 4.0 * std::comp_ellint_1(std::sin(amplitude)) / w;
    MotionSpec spec = in_orbit(2.0 * period);
    spec.attitude.zxz = Vec3(amplitude, 0, 0);
    const Motion motion = solved(body_with(moments), spec).motion;
    const auto angle_at = [&](double t) {
      const Vec3 x_S = motion.at(t).q_SB * Vec3::UnitX();
      return std::remainder(std::atan2(x_S.y(), x_S.x()) - t, 2.0 * kPi);
    };
    expect_residual("a quarter", std::abs(angle_at(0.25 * period)), 1e-9);
    expect_residual("half", std::abs(angle_at(0.5 * period) + amplitude), 1e-9);
    expect_residual("two", std::abs(angle_at(2.0 * period) - amplitude), 1e-9);
  }
}

// In the frame that goes round with the orbit all is constant in time: its energy is kept.
TEST(GravityGradient, KeepsJacobisIntegral) {
  const Vec3 moments(1.0, 1.3, 1.7);
  MotionSpec spec = in_orbit(20.0);
  spec.attitude.zxz = Vec3(0.3, 0.7, -0.2);
  spec.spin.body = Vec3(0.4, -0.3, 1.4);
  const Simulation found = solved(body_with(moments), spec);
  EXPECT_FALSE(found.report.record.drift.energy.has_value());
  const auto integral = [&](double t) {
    const Sample now = found.motion.at(t);
    const Vec3 away_B = now.q_SB.conjugate() * Vec3(std::cos(t), std::sin(t), 0.0);
    return 0.5 * now.w_B.dot(moments.cwiseProduct(now.w_B)) +
           1.5 * away_B.dot(moments.cwiseProduct(away_B)) - now.L_S.z();
  };
  for (const double t : {3.0, 11.0, 20.0})
    expect_residual("integral", std::abs(integral(t) - integral(0.0)), 1e-10);
}

// Which satellites stay with one side to the Earth (DeBra and Delp, J. Astronaut. Sci. 8 (1961)
// 14): the moments by k1 = (In - Ir)/It and k3 = (In - It)/Ir; k1 > k3, k1 k3 > 0 and 1 + 3 k1 + k1
// k3 > 4 sqrt(k1 k3).
TEST(GravityGradient, IsStableWhereTheorySays) {
  int stable = 0;
  for (const auto& [k1, k3] : {std::pair{0.6, 0.3},
                               {0.8, 0.2},
                               {0.9, 0.5},
                               {-0.02, -0.8},
                               {-0.05, -0.3},
                               {-0.05, -0.9},
                               {0.3, 0.6},
                               {0.5, -0.5},
                               {-0.5, 0.5},
                               {-0.5, -0.7},
                               {-0.3, -0.1},
                               {-0.2, -0.6}}) {
    const double product = k1 * k3;
    const bool stays =
        k1 > k3 && product > 0.0 && 1.0 + 3.0 * k1 + product > 4.0 * std::sqrt(product);
    stable += stays ? 1 : 0;
    const double ahead = (1.0 - k3) / (1.0 - k1);
    MotionSpec spec = in_orbit(20.0 * 2.0 * kPi);
    const Quat nudge = exp_rotation(1e-5 * Vec3(1, -1, 1));
    spec.attitude.quaternion = Eigen::Vector4d(nudge.w(), nudge.x(), nudge.y(), nudge.z());
    // what leaves the equilibrium tumbles, too wildly to be known
    NumericsSpec numerics;
    numerics.method = "dop853";
    numerics.tolerance = 1e-10;
    const Motion motion = solved(body_with({1.0, ahead, ahead + k3}), spec, numerics).motion;
    double farthest = 0.0;
    for (int i = 0; i <= 400; ++i) {
      const double t = spec.duration * i / 400;
      farthest =
          std::max(farthest, rotation_angle_between(motion.at(t).q_SB, exp_rotation({0, 0, t})));
    }
    EXPECT_EQ(farthest < 1e-3, stays) << k1 << " " << k3 << ": " << farthest;
  }
  EXPECT_EQ(stable, 6);
}

TEST(GravityGradient, NeedsAnOrbit) {
  MotionSpec spec = in_orbit(1.0);
  spec.torque[0].rate = 0.0;
  expect_input_error(
      [&] {
        solved(body_with({1, 1.3, 1.6}), spec);
      },
      "motion.torque[0].rate",
      "must not be 0");
  spec.torque[0].rate.reset();
  expect_input_error([&] { solved(body_with({1, 1.3, 1.6}), spec); }, "motion.torque[0]", "rate");
}

// so short that fixed steps would not see it, so strong that such a torque for the whole time would
// need a million steps
TEST(Torque, APulseIsSeenByStepsThatChooseTheirLength) {
  const BodySpec body = body_with({1, 1.3, 1.7});
  MotionSpec spec = spun({0.4, -0.1, 1.0}, 10.0);
  spec.torque = {constant_between(1.0, 1.0 + 1e-9)};
  spec.torque[0].space = Vec3(1e9, 0, 0);
  const BodyModel model = make_model(body, spec);
  const Motion motion = simulate(model, spec, {}, 1e-4).motion;
  const Vec3 change = motion.at(10.0).L_S - motion.at(0.0).L_S;
  expect_residual("tau t", (change - Vec3(1, 0, 0)).norm(), 1e-5);
  // roundings of the time near the switches do as much as this torque in 1e-16 s: no finer answer
  EXPECT_THROW(simulate(model, spec, {}, 1e-11), Error);
  for (const char* method : {"rk4", "gauss6"}) {
    NumericsSpec numerics;
    numerics.method = method;
    expect_input_error([&] { solved(body, spec, numerics); },
                       "numerics.method",
                       "has fixed steps, which do not end where a load is switched; dop853");
  }
}

TEST(Torque, EndsAfterItBegins) {
  MotionSpec spec = spun({0, 0, 1});
  spec.torque = {constant_between(2.0, 1.0)};
  spec.torque[0].space = Vec3(1, 0, 0);
  expect_input_error(
      [&] {
        solved(body_with({1, 1.3, 1.6}), spec);
      },
      "motion.torque[0].until",
      "before it has begun: it begins at 2 s");
  spec.torque[0].until = 2.4;
  spec.torque[0].ramp = 0.5;
  expect_input_error(
      [&] {
        solved(body_with({1, 1.3, 1.6}), spec);
      },
      "motion.torque[0].until",
      "it is whole at 2.5 s");
}

// 0.1 + 0.2 is more than 0.3 in binary numbers; the impulse of the triangle is its height times the
// length of one ramp
TEST(Torque, EndsAsSoonAsItIsWhole) {
  MotionSpec spec = spun({0, 0, 0}, 1.0);
  spec.torque = {constant_between(0.1, 0.3, 0.2)};
  spec.torque[0].body = Vec3(1, 0, 0);
  const BodySpec body = body_with({1, 1.3, 1.6});
  expect_residual("omega", std::abs(solved(body, spec).motion.at(1.0).w_B.x() - 0.2), 1e-13);
  spec.torque[0].until = 0.2999;
  expect_input_error([&] { solved(body, spec); }, "motion.torque[0].until", "it is whole at 0.3 s");
}

// SciMLBenchmarks, RigidBody_wpd, from t = 0 to 10, computed to 18 digits by two other methods:
// w1' = -2 w2 w3, w2' = 1.25 w1 w3, w3' = -.5 w1 w2 + sin(t)^2 / 4 are the equations of the moments
// (1, 4, 6) with a torque that is half constant and half at twice the rate
TEST(Torque, PublishedForcedBody) {
  BodySpec body = body_with({1, 4, 6});
  body.mathematical = true;
  MotionSpec spec = spun({1, 0, 0.9}, 10.0);
  spec.torque = {load("constant"), load("constant")};
  spec.torque[0].body = Vec3(0, 0, 0.75);
  spec.torque[1].body = Vec3(0, 0, -0.75);
  spec.torque[1].rate = 2.0;
  const Vec3 wanted(-0.668862422980134302, -0.587698402204068395, 2.01077739307361082);
  expect_residual("omega", (solved(body, spec).motion.at(10.0).w_B - wanted).norm(), 1e-10);
}

// the classical method keeps its order when the torque depends on time
TEST(Torque, OrderIsKeptInTime) {
  MotionSpec spec = spun({0.4, -0.1, 1.0}, 2.0);
  spec.torque = {load("constant")};
  spec.torque[0].body = Vec3(0.5, 0.8, -0.3);
  spec.torque[0].rate = 3.0;
  const BodySpec body = body_with({1, 1.3, 1.7});
  const Motion exact = solved(body, spec).motion;
  for (const auto& [method, order] : {std::pair{"explicit_euler", 1.0}, {"rk4", 4.0}}) {
    NumericsSpec numerics;
    numerics.method = method;
    double last = 0.0;
    for (const double step : {0.04, 0.02}) {
      numerics.step = step;
      const double error = turn_between(solved(body, spec, numerics).motion.at(2.0), exact.at(2.0));
      if (last > 0.0) {
        EXPECT_NEAR(std::log2(last / error), order, 0.15) << method;
      }
      last = error;
    }
  }
}

TEST(Damping, OfSpinSlowsASphereDown) {
  MotionSpec spec = spun({0.4, -0.1, 1.0});
  spec.torque = {load("damping")};
  spec.torque[0].c = 0.6;
  spec.torque[0].of = "spin";
  const Simulation s = solved(body_with({2, 2, 2}), spec);
  EXPECT_EQ(s.report.model, "ode");
  const Vec3 w = s.motion.at(0.0).w_S;
  for (const double t : {1.0, 4.0})
    expect_residual("exp", (s.motion.at(t).w_S - std::exp(-0.3 * t) * w).norm(), 1e-11);
}

// a spring on the centre of mass: a harmonic oscillator, and a rotation that knows nothing of it
TEST(Spring, OnTheCenterIsAnOscillator) {
  BodySpec body = body_with({1, 1.3, 1.7});
  body.mass = 2.0;
  MotionSpec spec = spun({0.4, -0.1, 1.0}, 5.0);
  spec.position = Vec3(1, 0.5, 0);
  spec.velocity = Vec3(0, 0.3, -0.2);
  const Motion free = solved(body, spec).motion;
  spec.torque = {load("spring")};
  spec.torque[0].k = 8.0;
  const Simulation s = solved(body, spec);
  EXPECT_EQ(s.report.model, "ode6");
  for (const double t : {0.4, 2.9, 5.0}) {
    const Vec3 wanted = spec.position * std::cos(2 * t) + spec.velocity * std::sin(2 * t) / 2;
    expect_residual("cosine", (s.motion.at(t).center_S - wanted).norm(), 1e-10);
    expect_residual("rotation", turn_between(s.motion.at(t), free.at(t)), 1e-10);
    expect_residual("energy", std::abs(s.motion.at(t).energy - s.motion.at(0).energy), 1e-10);
  }
}

// on a corner it turns the body too; dP/dt = F and dL/dt = tau along the motion (notes, eqs. 19,
// 21)
TEST(Spring, OnACornerKeepsEnergyAndObeysNewton) {
  BodySpec body = body_with({0.02, 0.03, 0.04});
  MotionSpec spec = spun({1.0, -0.4, 2.0}, 3.0);
  spec.gravity = Vec3(0, 0, -9.81);
  spec.position = Vec3(0.2, 0.1, -1);
  spec.torque = {load("spring")};
  spec.torque[0].k = 30.0;
  spec.torque[0].length = 0.6;
  spec.torque[0].at = Vec3(0.1, 0.15, 0.05);
  const Simulation s = solved(body, spec);
  EXPECT_EQ(s.report.model, "ode6");
  EXPECT_LT(s.report.record.drift.energy.value(), 1e-9);
  EXPECT_FALSE(s.report.record.drift.momentum.has_value());
  const BodyModel& model = s.motion.model();
  const double h = 1e-4;
  for (const double t : {0.5, 1.4, 2.8}) {
    const Sample now = s.motion.at(t);
    const Sample before = s.motion.at(t - h), after = s.motion.at(t + h);
    const Vec3 corner = point_position(model, now, *spec.torque[0].at);
    const Vec3 pull = -30.0 * (corner.norm() - 0.6) * corner.normalized();
    const Vec3 acceleration = (after.reference_velocity_S - before.reference_velocity_S) / (2 * h);
    EXPECT_LT((acceleration - pull - *spec.gravity).norm(), 1e-4);
    const Vec3 torque = (corner - now.center_S).cross(pull);
    EXPECT_LT(((after.L_S - before.L_S) / (2 * h) - torque).norm(), 1e-5);
  }
}

// notes, eq. 22: the couple gives the same motion wherever its two points are moved; a single force
// does not
TEST(Couple, IsTheSameForEveryPairOfPointsAndASingleForceIsNot) {
  BodySpec body = body_with({1, 1.3, 1.7});
  const auto moved = [&](const char* kind, const Vec3& shift) {
    MotionSpec spec = spun({0.4, -0.1, 1.0});
    spec.torque = {load(kind)};
    spec.torque[0].space = Vec3(0.2, 0.1, -0.3);
    spec.torque[0].at = Vec3(0.5, 0, 0.2) + shift;
    if (std::string(kind) == "couple") spec.torque[0].opposite = Vec3(-0.5, 0.1, 0) + shift;
    return solved(body, spec);
  };
  const Vec3 shift(0.3, -0.8, 0.4);
  const Simulation couple = moved("couple", Vec3::Zero());
  const Simulation other = moved("couple", shift);
  EXPECT_LT(couple.report.record.drift.energy.value(), 1e-9);
  const Simulation single = moved("force", Vec3::Zero());
  const Simulation far = moved("force", shift);
  EXPECT_EQ(single.report.model, "ode") << "its path is known in closed form";
  for (const double t : {2.0, 4.0}) {
    expect_residual("couple", turn_between(couple.motion.at(t), other.motion.at(t)), 2e-11);
    EXPECT_EQ(couple.motion.at(t).center_S, Vec3::Zero());
    EXPECT_GT(turn_between(single.motion.at(t), far.motion.at(t)), 0.1);
    // both single forces move the centre of mass alike
    const Vec3 parabola = 0.5 * t * t * Vec3(0.2, 0.1, -0.3);
    EXPECT_LT((single.motion.at(t).center_S - parabola).norm(), 1e-14);
    EXPECT_LT((far.motion.at(t).center_S - parabola).norm(), 1e-14);
    expect_residual("energy", std::abs(far.motion.at(t).energy - far.motion.at(0).energy), 1e-10);
  }
}

// a rocket: a force fixed in the body pushes where the body points
TEST(Force, FixedInTheBodyNeedsSixDegrees) {
  MotionSpec spec = spun({0, 0, 2.0}, 3.0);
  spec.attitude = {};
  spec.torque = {load("force")};
  spec.torque[0].body = Vec3(0.7, 0, 0);
  const Simulation s = solved(body_with({1, 1.3, 1.7}), spec);
  EXPECT_EQ(s.report.model, "ode6");
  for (const double t : {1.0, 3.0}) {
    // the integral of 0.7 (cos 2t, sin 2t), twice
    const Vec3 wanted(0.7 * (1 - std::cos(2 * t)) / 4, 0.7 * (t / 2 - std::sin(2 * t) / 4), 0);
    expect_residual("path", (s.motion.at(t).center_S - wanted).norm(), 1e-10);
  }
}

TEST(Force, OnAPivotTurnsTheBodyOnly) {
  BodySpec body = body_with({1, 1.3, 1.7});
  body.about = "pivot";
  MotionSpec spec = spun({0.4, -0.1, 1.0});
  spec.hold = "pivot";
  spec.gravity = Vec3(0, 0, 0);
  spec.torque = {load("force")};
  spec.torque[0].at = Vec3(0, 0, 0.5);
  spec.torque[0].space = Vec3(0, 0, -2.0);
  // a weight of 2 N at 0.5 m is gravity on a centre of mass there
  BodySpec heavy = body;
  heavy.mass = 2.0;
  heavy.center_of_mass = Vec3(0, 0, 0.5);
  heavy.mathematical = true;
  MotionSpec by_gravity = spec;
  by_gravity.torque.clear();
  by_gravity.gravity = Vec3(0, 0, -1.0);
  const Simulation a = solved(body, spec);
  const Simulation b = solved(heavy, by_gravity);
  for (const double t : {1.0, 4.0})
    expect_residual("weight", turn_between(a.motion.at(t), b.motion.at(t)), 5e-11);
}

TEST(Models, BiggerOnesGiveTheSameAndSmallerOnesAreRefused) {
  MotionSpec flight = spun({0.4, -0.1, 1.0}, 2.0);
  flight.gravity = Vec3(0, 0, -9.81);
  flight.velocity = Vec3(1, 0, 3);
  const BodySpec body = body_with({1, 1.3, 1.7});
  const Simulation least = solved(body, flight);
  EXPECT_EQ(least.report.model, "asymmetric");
  for (const char* bigger : {"ode", "ode6"}) {
    NumericsSpec numerics;
    numerics.model = bigger;
    const Simulation s = solved(body, flight, numerics);
    EXPECT_EQ(s.report.model, bigger);
    for (const double t : {0.5, 2.0}) {
      expect_residual(bigger, turn_between(s.motion.at(t), least.motion.at(t)), 2e-11);
      expect_residual(
          bigger, (s.motion.at(t).center_S - least.motion.at(t).center_S).norm(), 2e-11);
      expect_residual(bigger, std::abs(s.motion.at(t).energy - least.motion.at(t).energy), 1e-9);
    }
  }

  const auto refused = [&](const MotionSpec& spec, const NumericsSpec& numerics) {
    return [=, &body] {
      solved(body, spec, numerics);
    };
  };
  NumericsSpec numerics;
  numerics.model = "ode";
  MotionSpec sprung = flight;
  sprung.torque = {load("spring")};
  sprung.torque[0].k = 1.0;
  expect_input_error(refused(sprung, numerics), "numerics.model", "depends on where the body is");
  numerics.model = "asymmetric";
  expect_input_error(refused(sprung, numerics), "numerics.model", "torques act");
  numerics.model = "ode6";
  MotionSpec held = spun({0.4, -0.1, 1.0});
  held.hold = "pivot";
  expect_input_error(refused(held, numerics), "numerics.model", "fixed point");
  numerics = {};
  numerics.method = "implicit_midpoint";
  expect_input_error(refused(sprung, numerics), "numerics.method", "dop853");
}

}  // namespace
}  // namespace polhode
