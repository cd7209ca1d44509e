// SPDX-License-Identifier: MIT
// Bodies in gimbals and in frames that turn, against what is known of their motion.
#include <algorithm>
#include <cmath>

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "math/so3.h"
#include "motion/simulate.h"
#include "motion/steppers/derivative.h"
#include "support/expect_error.h"
#include "support/motions.h"

namespace polhode {
namespace {

using test::expect_input_error;

constexpr double kAcross = 2.0, kAlong = 3.0;  // kg m^2

BodySpec rotor(const Vec3& center = Vec3::Zero()) {
  BodySpec body;
  body.moments = Vec3(kAcross, kAcross, kAlong);
  body.mathematical = true;
  body.about = "pivot";
  body.mass = 1.0;
  body.center_of_mass = center;
  return body;
}

MotionSpec on_pivot(const Vec3& angles, const Vec3& rates, double duration) {
  MotionSpec motion;
  motion.hold = "pivot";
  motion.duration = duration;
  motion.attitude.zxz = angles;
  motion.spin.rates = rates;
  return motion;
}

Motion trusted_motion(const BodySpec& body, const MotionSpec& spec, double accuracy_rad = 1e-10) {
  const Simulation done = simulate(make_model(body, spec), spec, NumericsSpec{}, accuracy_rad);
  EXPECT_EQ(fmt::format("{}", fmt::join(done.report.reliability.doubts, "; ")), "");
  return done.motion;
}

double greatest_energy_error(const Motion& motion) {
  double worst = 0.0;
  for (int i = 0; i <= 50; ++i) {
    const Drift drift = drift_at(motion, motion.duration() * i / 50.0);
    worst = std::max(worst, std::abs(drift.energy.value_or(INFINITY)));
  }
  return worst;
}

// An observer who turns sees the closed form of the motion against the stars, turned back.
TEST(FrameRotation, IsTheMotionAgainstTheStarsSeenFromTheFrame) {
  const Vec3 frame(0.3, -0.5, 0.8);
  MotionSpec seen = on_pivot({0.4, 1.0, 0.2}, {0.7, -0.4, 3.0}, 8.0);
  MotionSpec stars = seen;
  seen.frame_rotation = frame;
  const Quat q = from_zxz_angles(*seen.attitude.zxz);
  const Vec3 w_S = q * body_rate_from_zxz_rates(*seen.attitude.zxz, *seen.spin.rates);
  stars.spin.rates = {};
  stars.spin.space = w_S + frame;
  const Motion turning = trusted_motion(rotor(), seen);
  const Motion exact = trusted_motion(rotor(), stars);
  for (double t = 0.0; t <= 8.0; t += 0.5) {
    const Sample a = turning.at(t), b = exact.at(t);
    const Quat back = exp_rotation(-t * frame);
    EXPECT_LT((back * b.q_SB).angularDistance(a.q_SB), 1e-9) << t;
    EXPECT_LT((back * b.w_S - frame - a.w_S).norm(), 1e-8) << t;
  }
  EXPECT_LT(greatest_energy_error(turning), 1e-9);
}

// The same for Lagrange's top on a turntable, whose weight turns with it.
TEST(FrameRotation, OfATurntableIsThatOfATopOnFirmGround) {
  const Vec3 frame(0.0, 0.0, 1.3);
  MotionSpec seen = on_pivot({0.0, 0.8, 0.0}, {0.0, 0.0, 9.0}, 6.0);
  MotionSpec ground = on_pivot({0.0, 0.8, 0.0}, {1.3, 0.0, 9.0}, 6.0);
  seen.frame_rotation = frame;
  const BodySpec top = rotor({0.0, 0.0, 0.4});
  const Motion turning = trusted_motion(top, seen);
  const Motion exact = trusted_motion(top, ground);
  for (double t = 0.0; t <= 6.0; t += 0.5) {
    const Quat back = exp_rotation(-t * frame);
    EXPECT_LT((back * exact.at(t).q_SB).angularDistance(turning.at(t).q_SB), 1e-9) << t;
  }
}

// Held level, the axle swings about north. With W the level part of the frame's rotation and p = I3
// w3 the momentum along the axle, the Lagrangian has the potential -p W cos phi - (I1 + A) W^2
// sin^2 phi/2 - C W^2 cos^2 phi/2, where A and C are the inner ring's moments about the line of
// nodes and the axle; rotor and rings turn about the vertical together.
TEST(Gyrocompass, FindsNorthWithThePeriodOfTheory) {
  const double level = 0.3, spin = 50.0, swing = 1e-4;
  const Vec3 inner(0.2, 0.3, 0.25);
  const double outer = 0.4;
  // the axle is (sin phi, -cos phi, 0): north is -Y at phi = 0
  MotionSpec spec = on_pivot({swing, 0.5 * kPi, 0.0}, {0.0, 0.0, spin}, 1.0);
  spec.frame_rotation = Vec3(0.0, -level, 0.9);
  spec.gimbals = GimbalsSpec{outer, inner, Vec3::Zero(), "inner"};
  const double about_vertical = kAcross + inner.y() + outer;
  const double against_stars = spin + level;  // at the start, to second order of the swing
  const double pull =
      kAlong * against_stars * level - (kAcross + inner.x() - inner.z()) * level * level;
  const double period = 2.0 * kPi * std::sqrt(about_vertical / pull);
  spec.duration = 3.0 * period;
  const Motion motion = trusted_motion(rotor(), spec, 1e-9);
  const auto azimuth = [&](double t) {
    const Vec3 axle = motion.at(t).q_SB * Vec3::UnitZ();
    EXPECT_LT(std::abs(axle.z()), 1e-9) << "the axle stays level";
    return std::atan2(axle.x(), -axle.y());
  };
  for (double turns = 0.0; turns <= 3.0; turns += 0.125) {
    EXPECT_NEAR(azimuth(turns * period), swing * std::cos(2.0 * kPi * turns), 1e-7 * swing + 1e-10)
        << turns;
  }
  EXPECT_LT(greatest_energy_error(motion), 1e-9);
}

// The axle that may only tilt, in the meridian, points to the pole: a gyroscope that finds
// latitude.
TEST(Gyrocompass, ThatTiltsInTheMeridianFindsThePole) {
  const double latitude = 0.9, rate = 0.4, spin = 40.0;
  // axle (0, -sin theta, cos theta): in the plane of the frame's rotation
  const double pole = 0.5 * kPi - latitude;
  MotionSpec spec = on_pivot({0.0, pole + 0.2, 0.0}, {0.0, 0.0, spin}, 20.0);
  spec.frame_rotation = rate * Vec3(0.0, -std::cos(latitude), std::sin(latitude));
  spec.gimbals = GimbalsSpec{0.1, Vec3(0.1, 0.1, 0.1), Vec3(0.0, 3.0, 0.0), "outer"};
  const Motion motion = trusted_motion(rotor(), spec, 1e-9);
  const Vec3 axle = motion.at(20.0).q_SB * Vec3::UnitZ();
  EXPECT_LT(std::abs(axle.x()), 1e-9);
  EXPECT_NEAR(angle_between(axle, *spec.frame_rotation), 0.0, 2e-4);
}

// Rings that turn freely keep energy and the momentum about the vertical of all three bodies.
TEST(GimbalsMotion, KeepsEnergyAndMomentumAboutTheVertical) {
  MotionSpec spec = on_pivot({0.3, 1.0, 0.0}, {1.5, -0.8, 6.0}, 10.0);
  spec.gimbals = GimbalsSpec{0.7, Vec3(0.3, 0.5, 0.4), Vec3::Zero(), {}};
  const Motion motion = trusted_motion(rotor({0.0, 0.0, 0.2}), spec);
  EXPECT_LT(greatest_energy_error(motion), 1e-9);
  const auto about_vertical = [&](double t) {
    const State s = motion.state_at(t);
    const GimbalPose pose = s.rings;
    const double rings = 0.7 + 0.5 * std::pow(std::sin(pose.angles[1]), 2) +
                         0.4 * std::pow(std::cos(pose.angles[1]), 2);
    return motion.at(t).L_S.z() + rings * pose.rates[0];
  };
  for (double t = 0.0; t <= 10.0; t += 0.5)
    EXPECT_NEAR(about_vertical(t), about_vertical(0.0), 1e-8) << t;
}

// What friction takes in each bearing is what is missing.
TEST(GimbalsMotion, FrictionTakesItsPower) {
  MotionSpec spec = on_pivot({0.3, 1.0, 0.0}, {1.5, -0.8, 6.0}, 4.0);
  const Vec3 friction(0.3, 0.2, 0.1);
  spec.gimbals = GimbalsSpec{0.7, Vec3(0.3, 0.5, 0.4), friction, {}};
  const Motion motion = trusted_motion(rotor(), spec);
  const auto power = [&](double t) {
    const State s = motion.state_at(t);
    const GimbalPose pose = s.rings;
    return friction.dot(pose.rates.cwiseAbs2());
  };
  // Simpson's rule
  const int pieces = 4000;
  const double h = spec.duration / pieces;
  double lost = power(0.0) + power(spec.duration);
  for (int i = 1; i < pieces; ++i)
    lost += (i % 2 == 1 ? 4.0 : 2.0) * power(i * h);
  lost *= h / 3.0;
  EXPECT_NEAR(motion.at(0.0).energy - motion.at(spec.duration).energy, lost, 1e-8 * lost);
  EXPECT_FALSE(drift_at(motion, 1.0).energy);
}

// The axle passes the vertical and beyond: in gimbal lock the rings know where they are, although
// the attitude of the body does not tell it. Back in time the motion comes to where it began.
TEST(GimbalsMotion, PassesGimbalLock) {
  MotionSpec spec = on_pivot({0.3, 0.6, 0.1}, {0.5, -1.0, 2.0}, 3.0);
  spec.gimbals = GimbalsSpec{0.5, Vec3(0.2, 0.3, 0.25), Vec3::Zero(), {}};
  const Motion motion = trusted_motion(rotor({0.0, 0.0, 0.1}), spec);
  double least = 1.0;
  for (double t = 0.0; t < 3.0; t += 0.01)
    least = std::min(least, motion.state_at(t).rings.angles[1]);
  EXPECT_LT(least, -0.1);
  for (double t = 0.0; t < 2.99; t += 0.01)
    EXPECT_GT(motion.at(t).q_SB.dot(motion.at(t + 0.01).q_SB), 0.9) << "no jump to -q at " << t;
  EXPECT_LT(greatest_energy_error(motion), 1e-9);

  const GimbalPose end = motion.state_at(3.0).rings;
  MotionSpec back = on_pivot(end.angles, -end.rates, 3.0);
  back.gimbals = spec.gimbals;
  const Quat home = trusted_motion(rotor({0.0, 0.0, 0.1}), back).at(3.0).q_SB;
  EXPECT_LT(home.angularDistance(motion.at(0.0).q_SB), 1e-8);
}

// Friction in rings without mass, whose axle passes within 1e-6 rad of gimbal lock, where it is
// stiff, or brakes so much that it passes right through: as rings move that are so light, in
// explicit steps.
TEST(GimbalsMotion, OfRingsWithoutMassInLockIsThatOfTheLightest) {
  BodySpec sphere = rotor();
  sphere.moments = Vec3::Ones();
  MotionSpec spec = on_pivot({0.3, 0.0011, 0.2}, {1.0, -1.0, 3.0}, 2.0);
  NumericsSpec explicitly;
  explicitly.method = "dop853";
  for (const auto& [friction, light] :
       {std::pair(1e-12, 1e-19), std::pair(1e-9, 1e-19), std::pair(1e-6, 1e-17)}) {
    spec.gimbals = GimbalsSpec{0.0, Vec3::Zero(), Vec3(0.0, 0.0, friction), {}};
    const Simulation done = simulate(make_model(sphere, spec), spec, NumericsSpec{}, 1e-7);
    EXPECT_EQ(fmt::format("{}", fmt::join(done.report.reliability.doubts, "; ")), "") << friction;
    EXPECT_LT(done.report.record.steps, 10'000) << friction;
    // nothing turns the body about the vertical
    const double begins = done.motion.at(0.0).L_S.z();
    EXPECT_NEAR(done.motion.at(2.0).L_S.z(), begins, 1e-7 * begins) << friction;
    spec.gimbals->outer = light;
    const Motion other = simulate(make_model(sphere, spec), spec, explicitly, 1e-7).motion;
    for (double t = 0.0; t <= 2.0; t += 0.1) {
      EXPECT_LT(other.at(t).q_SB.angularDistance(done.motion.at(t).q_SB), 2e-6)
          << friction << " at " << t;
    }
  }
  // and what explicit steps cannot do
  spec.gimbals = GimbalsSpec{0.0, Vec3::Zero(), Vec3(0.0, 0.0, 1e-3), {}};
  trusted_motion(sphere, spec, 1e-7);
}

// Angular velocities there, from equations of these alone in which the rings are constraints,
// integrated by another program with a tolerance of 1e-13 and steps of 2e-8 s in lock.
TEST(GimbalsMotion, InLockAgreesWithEquationsOfTheBodyAlone) {
  BodySpec sphere = rotor();
  sphere.moments = Vec3::Ones();
  MotionSpec spec = on_pivot({0.3, 0.0011, 0.2}, {1.0, -1.0, 3.0}, 2.0);
  for (const auto& [friction, w] :
       {std::pair(1e-12, Vec3(-0.954358794747, -0.298672040981, 3.999998185)),
        std::pair(1e-9, Vec3(-0.951876755798, -0.297895850802, 3.999998185)),
        std::pair(1e-7, Vec3(-0.557984525273, -0.190811568162, 3.999998185))}) {
    spec.gimbals = GimbalsSpec{0.0, Vec3::Zero(), Vec3(0.0, 0.0, friction), {}};
    EXPECT_LT((trusted_motion(sphere, spec, 1e-7).at(2.0).L_S - w).norm(), 2e-8) << friction;
  }
}

// It may also begin there, if the scene gives the angles.
TEST(GimbalsMotion, BeginsInGimbalLock) {
  MotionSpec spec = on_pivot({0.3, 0.0, 0.0}, {0.5, 1.0, 2.0}, 1.0);
  spec.gimbals = GimbalsSpec{0.5, Vec3(0.2, 0.3, 0.25), Vec3::Zero(), {}};
  const Motion motion = trusted_motion(rotor(), spec);
  EXPECT_EQ(motion.state_at(0.0).rings.rates, *spec.spin.rates);
  EXPECT_LT(greatest_energy_error(motion), 1e-9);
}

// Steps begin with the very angles and rates at which the last one ended. Attitude and momentum
// tell them with round-off over the square of the sine of the tilt, which every step would add.
TEST(GimbalsMotion, LosesNothingBetweenSteps) {
  MotionSpec spec = on_pivot({0.3, 0.7, 0.4}, {0.4, -1.0, 2.0}, 2.0);
  spec.gravity = Vec3(5.0, 4.0, -3.0);
  spec.gimbals = GimbalsSpec{0.5, Vec3(0.2, 0.3, 0.25), Vec3::Zero(), {}};
  const BodyModel model = make_model(rotor(), spec);
  State s = start_state(model, spec);
  const GimbalPose rings{{0.7, 0.002, -0.4}, {1.0, -0.6, 5.0}};
  set_rings(model, rings, s);
  const StateVector<kInGimbals> v = to_vector<kInGimbals>(s);
  EXPECT_EQ(v.head<3>(), rings.angles);
  EXPECT_EQ(v.tail<3>(), rings.rates);
}

TEST(GimbalsMotion, WithoutMassAndFrictionAreNone) {
  MotionSpec spec = on_pivot({0.3, 1.0, 0.0}, {1.5, -0.8, 6.0}, 1.0);
  spec.gimbals = GimbalsSpec{};
  EXPECT_FALSE(make_model(rotor(), spec).loads.gimbals);
}

// The zxz angles of the body say where the rings are if they are theirs: not about another axle,
// and not about another vertical.
TEST(GimbalsMotion, InLockOnlyTheirOwnAnglesTell) {
  const double right = 0.5 * kPi;
  BodySpec about_x;
  about_x.moments = Vec3(0.5, 1.0, 1.0);
  MotionSpec spec = on_pivot({0.0, right, right}, {0.0, 1.0, 0.7}, 3.0);
  spec.gimbals = GimbalsSpec{0.3, Vec3(0.1, 0.1, 0.1), Vec3(0.1, 0.1, 0.1), {}};
  const auto begin = [&](const BodySpec& body) {
    return start_state(make_model(body, spec), spec);
  };
  expect_input_error(
      [&] { begin(about_x); }, "motion.attitude", "are; tilt the axle by more than 0.001 rad");
  spec = on_pivot({right, right, 0.0}, {0.3, 1.0, 0.7}, 3.0);
  spec.gravity = Vec3(-1.0, 0.0, 0.0);
  spec.gimbals = GimbalsSpec{0.3, Vec3(0.1, 0.1, 0.1), Vec3::Zero(), {}};
  expect_input_error(
      [&] { begin(rotor()); }, "motion.attitude", "are; tilt the axle by more than 0.001 rad");
  // what the rings then do is what the scene says
  spec.attitude.zxz = Vec3(right, right - 0.01, 0.0);
  const State s = begin(rotor());
  const BodyModel model = make_model(rotor(), spec);
  EXPECT_LT(
      (angular_velocity_of(*model.loads.gimbals, s.rings) - angular_velocity(model, s.y)).norm(),
      1e-12);
}

TEST(GimbalsMotion, RefusesWhatHasNoMotion) {
  MotionSpec spec = on_pivot({0.3, 0.0, 0.0}, {0.5, 1.0, 2.0}, 1.0);
  spec.gimbals = GimbalsSpec{0.0, Vec3(0.1, 0.1, 0.0), Vec3(0.1, 0.0, 0.0), {}};
  const auto start = [&](const BodySpec& body) {
    start_state(make_model(body, spec), spec);
  };
  expect_input_error(
      [&] { start(rotor()); }, "motion.attitude", "rings without mass have no motion");
  spec.gimbals->inner.z() = 1e-3;
  start(rotor());
  BodySpec rod;
  rod.moments = Vec3(1.0, 1.0, 0.0);
  expect_input_error([&] { start(rod); }, "motion.gimbals", "the line on which all mass lies");
}

TEST(GimbalsMotion, RefusesWhatRingsCannotDo) {
  const auto start = [](MotionSpec spec) {
    start_state(make_model(rotor({0.0, 0.0, 0.1}), spec), spec);
  };
  MotionSpec spec = on_pivot({0.0, 0.0, 0.0}, {0.0, 0.0, 5.0}, 1.0);
  spec.gimbals = GimbalsSpec{1.0, Vec3::Zero(), Vec3::Zero(), {}};
  start(spec);
  spec.gimbals->inner = Vec3(1.0, 1.0, 2.0);  // flat
  start(spec);
  spec.gimbals->inner = Vec3(1.0, 1.0, 2.1);
  expect_input_error([&] { start(spec); }, "motion.gimbals.inner", "no ring has these moments");
  spec.gimbals->inner = Vec3::Zero();
  spec.spin = {};
  spec.spin.body = Vec3(0.0, 0.0, 5.0);
  expect_input_error([&] { start(spec); }, "motion.attitude", "gimbal lock");
  spec.attitude.zxz = Vec3(0.0, 1.0, 0.0);
  spec.gimbals->clamp = "inner";
  start(spec);
  spec.spin = {};
  spec.spin.rates = Vec3(0.0, 0.5, 5.0);
  expect_input_error([&] { start(spec); }, "motion.spin", "turns the inner ring at 0.5 rad/s");
  spec.gimbals->clamp = "outer";
  start(spec);
  spec.spin.rates = Vec3(0.3, 0.5, 5.0);
  expect_input_error([&] { start(spec); }, "motion.spin", "turns the outer ring at 0.3 rad/s");
  spec.spin = {};
  spec.spin.steady = "slow";
  spec.spin.axial = 100.0;
  expect_input_error([&] { start(spec); }, "motion.spin.steady", "without motion.gimbals");
  spec.hold = "free";
  expect_input_error([&] { start(spec); }, "motion.gimbals", "is for a body on a pivot");
  spec.gimbals = {};
  spec.frame_rotation = Vec3(0.0, 0.0, 1.0);
  expect_input_error([&] { start(spec); }, "motion.frame_rotation", "is for a body on a pivot");
}

// A bearing damps the spin about its axle alone, exponentially.
TEST(BearingDamping, ActsAboutItsAxis) {
  MotionSpec spec = on_pivot({0.3, 1.0, 0.0}, {0.0, 0.0, 6.0}, 3.0);
  LoadSpec bearing;
  bearing.kind = "damping";
  bearing.of = "spin";
  bearing.c = 0.9;
  bearing.about = Vec3(0.0, 0.0, 2.0);
  spec.torque = {bearing};
  spec.spin = {};
  spec.spin.body = Vec3(1.0, 0.5, 6.0);
  const Motion motion = trusted_motion(rotor(), spec);
  for (double t = 0.0; t <= 3.0; t += 0.5) {
    const Vec3 w = motion.at(t).w_B;
    EXPECT_NEAR(w.z(), 6.0 * std::exp(-0.9 * t / kAlong), 1e-9) << t;
    EXPECT_NEAR(std::hypot(w.x(), w.y()), std::hypot(1.0, 0.5), 1e-9) << t;
  }
  spec.torque[0].of = {};
  expect_input_error([&] { make_model(rotor(), spec); }, "motion.torque[0].about", "of = \"spin\"");
}

}  // namespace
}  // namespace polhode
