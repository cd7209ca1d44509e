// SPDX-License-Identifier: MIT
// What round-off of a body does to its motion: arms and moments that are the difference of larger
// numbers.
#include <cmath>

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "motion/simulate.h"
#include "support/expect_error.h"
#include "support/tops.h"

namespace polhode {
namespace {

Simulation simulated(const BodySpec& body, const MotionSpec& motion, double accuracy_rad) {
  return simulate(make_model(body, motion), motion, NumericsSpec{}, accuracy_rad);
}
std::string doubts_of(const Simulation& done) {
  return fmt::format("{}", fmt::join(done.report.reliability.doubts, "; "));
}

BodySpec coin(double center) {
  BodySpec body;
  body.moments = Vec3(1e-8, 1e-8, 1.5e-8);
  body.mass = 1.0;
  body.center_of_mass = Vec3(0.0, 0.0, center);
  return body;
}

MotionSpec at_rest(const std::string& hold, double tilt, double duration) {
  MotionSpec motion;
  motion.hold = hold;
  motion.duration = duration;
  motion.attitude.zxz = Vec3(0.0, tilt, 0.0);
  motion.spin.body = Vec3::Zero();
  return motion;
}

// An arm of 2e-14 of what it is the difference of is exact where both are given, and swings a body
// that is small enough.
TEST(RoundedBody, ATinyLeverOfGivenPointsIsALever) {
  BodySpec body = coin(1.0);
  body.pivot = Vec3(0.0, 0.0, 0.99999999999998);
  const MotionSpec motion = at_rest("pivot", 0.1, 1000.0);
  const Simulation done = simulated(body, motion, 1e-3);
  EXPECT_EQ(doubts_of(done), "");
  // a pendulum that is upright: theta'' = k sin(theta)
  const double lever = 1.0 - 0.99999999999998;
  const double k = 9.80665 * lever / 1e-8;
  double theta = 0.1, rate = 0.0;
  const double h = 0.01;
  for (int i = 0; i < 100'000; ++i) {
    rate += 0.5 * h * k * std::sin(theta);
    theta += h * rate;
    rate += 0.5 * h * k * std::sin(theta);
  }
  const Vec3 axle = done.motion.at(1000.0).q_SB * Vec3::UnitZ();
  EXPECT_NEAR(std::atan2(-axle.y(), axle.z()), std::remainder(theta, 2.0 * kPi), 1e-4);
  // a millisecond is too short for it
  EXPECT_EQ(simulated(body, at_rest("pivot", 0.1, 1e-3), 1e-3).report.model, "symmetric");
}

TEST(RoundedBody, ATinyArmOfAForceIsAnArm) {
  MotionSpec motion = at_rest("free", 0.3, 1000.0);
  LoadSpec force;
  force.kind = "force";
  force.space = Vec3(1.0, 0.0, 0.0);
  force.at = Vec3(0.0, 0.0, 1.0);
  motion.torque = {force};
  const Simulation done = simulated(coin(0.99999999999998), motion, 1e-3);
  EXPECT_EQ(doubts_of(done), "");
  EXPECT_GT(done.motion.at(1000.0).q_SB.angularDistance(done.motion.at(0.0).q_SB), 0.5);
  // two forces at points that are not the same are a couple
  force.kind = "couple";
  force.opposite = Vec3(0.0, 0.0, 0.999999999999999);
  motion.torque = {force};
  EXPECT_NO_THROW(make_model(coin(1.0), motion));
  motion.torque[0].opposite = motion.torque[0].at;
  test::expect_input_error(
      [&] { make_model(coin(1.0), motion); }, "motion.torque[0].opposite", "at one point");
}

// where the centre of mass is calculated, such an arm is round-off
TEST(RoundedBody, ALeverOfRoundOffIsDoubted) {
  SolidSpec ball;
  ball.kind = "sphere";
  ball.radius = 0.005;
  ball.mass = 0.004;
  ball.at = Vec3(1.0, 0.0, 0.0);
  BodySpec body;
  body.parts = {ball};
  body.pivot = Vec3(1.0, 0.0, 1e-14);
  const Simulation longer = simulated(body, at_rest("pivot", 0.5 * kPi, 10'000.0), 1e-6);
  EXPECT_NE(doubts_of(longer).find("round-off of the moments of inertia"), std::string::npos);
  EXPECT_EQ(doubts_of(simulated(body, at_rest("pivot", 0.5 * kPi, 1.0), 1e-6)), "");
}

// The small moment of a strip that is turned has the round-off of the large ones.
TEST(RoundedBody, TheSmallMomentOfATurnedNeedleIsDoubted) {
  SolidSpec strip;
  strip.kind = "box";
  strip.size = Vec3(1.0, 0.001, 0.0005);
  strip.mass = 1.0;
  MotionSpec motion;
  motion.duration = 100.0;
  BodySpec body;
  body.parts = {strip};
  // the momentum of a spin about the long axis
  motion.spin.momentum_body = Vec3(1e-6, 0.0, 1e-3);
  EXPECT_EQ(doubts_of(simulated(body, motion, 1e-8)), "");
  body.parts[0].turn = Vec3(0.3, 0.7, 0.2);
  const Mat3 turn = make_model(body, motion).R_BP;
  motion.spin.momentum_body = Vec3(turn * Vec3(1e-6, 0.0, 1e-3));
  EXPECT_NE(doubts_of(simulated(body, motion, 1e-8)).find("round-off of the moments"),
            std::string::npos);
  EXPECT_EQ(doubts_of(simulated(body, motion, 1e-3)), "");
}

// Pulses so short that they have a few digits of time, and ramps so steep that one of these counts.
TEST(RoundedBody, StrongLoadsForAMomentAreDoubted) {
  MotionSpec motion = at_rest("free", 0.0, 10.0);
  BodySpec sphere;
  sphere.moments = Vec3::Ones();
  LoadSpec pulse;
  pulse.kind = "constant";
  const auto doubts = [&](double strength, double from, double until, double ramp) {
    pulse.body = Vec3(0.0, 0.0, strength);
    pulse.from = from;
    pulse.until = until;
    pulse.ramp = ramp;
    motion.torque = {pulse};
    return doubts_of(simulated(sphere, motion, 1e-6));
  };
  EXPECT_NE(doubts(1e14, 7.5, 7.50000000000001, 0.0).find("16 digits"), std::string::npos);
  EXPECT_NE(doubts(1e9, 7.0, 7.00000001, 3e-9).find("16 digits"), std::string::npos);
  EXPECT_EQ(doubts(1e9, 7.0, 7.00000001, 0.0), "");
  EXPECT_EQ(doubts(1e3, 7.0, 7.01, 3e-3), "");
}

// A force on a free body moves its place, without an arm too.
TEST(RoundedBody, StrongForcesForAMomentAreDoubted) {
  MotionSpec motion = at_rest("free", 0.0, 10.0);
  BodySpec sphere;
  sphere.moments = Vec3::Ones();
  sphere.mass = 1.0;
  LoadSpec pulse;
  pulse.kind = "force";
  pulse.at = Vec3::Zero();
  pulse.space = Vec3(0.0, 0.0, 1e14);
  pulse.from = 7.5;
  const auto doubts = [&](double until) {
    pulse.until = until;
    motion.torque = {pulse};
    return doubts_of(simulated(sphere, motion, 1e-6));
  };
  EXPECT_NE(doubts(7.50000000000001).find("16 digits"), std::string::npos);
  pulse.space = Vec3(0.0, 0.0, 1e3);
  EXPECT_EQ(doubts(7.51), "");
}

// Moments about a pivot, of a body that flies: those about its centre of mass are what is left.
TEST(RoundedBody, MomentsThatAreWhatIsLeftAreDoubted) {
  BodySpec body;
  body.moments = Vec3(3.84054849229771, 3.840548492298122, 4.994459074455927e-12);
  body.mass = 1.0;
  body.center_of_mass = Vec3(0.0, 0.0, 1.959731739880241);
  body.about = "pivot";
  MotionSpec motion;
  motion.duration = 50.0;
  motion.spin.body = Vec3(0.47603678650798736, 17.98336584195811, -3.550542479084095);
  EXPECT_NE(doubts_of(simulated(body, motion, 0.01)).find("round-off of the moments"),
            std::string::npos);
}

}  // namespace
}  // namespace polhode
