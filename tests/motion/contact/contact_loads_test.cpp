// SPDX-License-Identifier: MIT
// Loads on a body on a table: energy less the work of the table and of loads without a potential
// stays, so that a right motion is trusted.
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "motion/contact/contact_trajectory.h"
#include "support/expect_error.h"
#include "support/motions.h"
#include "support/on_table.h"

namespace polhode::test {
namespace {

LoadSpec load_of(const char* kind) {
  LoadSpec load;
  load.kind = kind;
  return load;
}

LoadSpec damping(const char* of, double c) {
  LoadSpec load = load_of("damping");
  load.of = of;
  load.c = c;
  return load;
}

// a torque or force of that size, in axes of space or of the body; `rate`: it swings, rad/s
LoadSpec directed(const char* kind, bool in_body, double size, double rate) {
  LoadSpec load = load_of(kind);
  const Vec3 vector = size * Vec3(0.6, -0.48, 0.64);
  (in_body ? load.body : load.space) = vector;
  if (kind == std::string("couple")) load.opposite = Vec3(0.0, -0.03, 0.02);
  if (kind != std::string("constant")) load.at = Vec3(0.05, 0.02, 0.03);
  if (rate != 0.0) load.rate = rate;
  return load;
}

using NamedLoad = std::pair<std::string, LoadSpec>;

std::vector<NamedLoad> loads_of_every_kind() {
  std::vector<NamedLoad> loads = {{"damping of momentum", damping("momentum", 1.0)},
                                  {"damping of spin", damping("spin", 0.005)},
                                  {"damping about an axis", damping("spin", 0.005)},
                                  {"spring", load_of("spring")},
                                  {"gravity gradient", load_of("gravity_gradient")}};
  loads[2].second.about = Vec3(0.0, 1.0, 1.0);
  loads[3].second.k = 2.0;
  loads[3].second.length = 0.05;
  loads[4].second.rate = 2.0;
  for (const char* kind : {"constant", "couple", "force"}) {
    const double size = kind == std::string("constant") ? 0.02 : 0.3;
    for (const bool in_body : {false, true}) {
      for (const double rate : {0.0, 9.0}) {
        const std::string where = in_body ? " in the body" : " in space";
        loads.emplace_back(kind + where + (rate != 0.0 ? ", swinging" : ""),
                           directed(kind, in_body, size, rate));
      }
    }
  }
  LoadSpec central = directed("force", false, 0.3, 9.0);
  central.at.reset();
  loads.emplace_back("force on the centre, swinging", central);
  return loads;
}

std::vector<std::pair<std::string, FrictionSpec>> laws_of_friction() {
  FrictionSpec none, moments = coulomb(0.3), turning = rolling();
  none.kind = "none";
  moments.rolling = 1e-3;
  moments.boring = 1e-3;
  turning.turntable = 1.5;
  return {{"none", none},
          {"rolling", rolling()},
          {"viscous", viscous(0.4)},
          {"coulomb", moments},
          {"turntable", turning}};
}

class LoadsOnTable : public testing::TestWithParam<std::size_t> {};

TEST_P(LoadsOnTable, AreCountedAsWork) {
  const BodySpec egg = ellipsoid_body(Vec3(0.1, 0.11, 0.12));
  const auto [law, friction] = laws_of_friction()[GetParam()];
  for (const auto& [name, load] : loads_of_every_kind()) {
    for (const double height : {0.0, 3.0}) {
      SCOPED_TRACE(law + ", " + name + (height > 0.0 ? ", in flight" : ""));
      MotionSpec spec = on_table(0.7, friction);
      spec.spin.space = Vec3(3.0, 0.0, 5.0);
      if (height > 0.0) spec.position = Vec3(0.0, 0.0, height);
      if (height > 0.0 || friction.kind != "rolling") spec.velocity = Vec3(0.2, 0.1, 0.0);
      spec.torque = {load};
      const Simulation found = simulated(egg, spec, 1e-7);
      EXPECT_EQ(found.report.reliability.doubts, std::vector<std::string>());
      ASSERT_TRUE(found.report.record.drift.energy);
      EXPECT_LT(*found.report.record.drift.energy, 1e-7);
      const Drift end = drift_at(found.motion, spec.duration);
      EXPECT_LT(std::abs(end.energy.value()), 1e-7);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(All, LoadsOnTable, testing::Range<std::size_t>(0, 5));

// nothing looks at forces on a body that lies: where they may move it, the motion ends with a line
TEST(ContactLoads, ABodyThatLiesIsNotHeldAgainstWhatMovesIt) {
  const auto lying = [](const FrictionSpec& friction) {
    MotionSpec spec = on_table(1.0, friction);
    spec.attitude.zxz = Vec3(0.0, 0.0002, 0.0);
    return spec;
  };
  const auto expect_refused = [](const MotionSpec& spec, const char* words) {
    expect_error([&] { integrated(disc_body(), spec, 1e-9); },
                 Fault::check_failed,
                 "motion.duration",
                 words);
  };
  MotionSpec lifted = lying(coulomb(0.1));
  lifted.torque = {load_of("force")};
  lifted.torque[0].space = Vec3(0.0, 0.0, 20.0);
  lifted.torque[0].rate = 6.283;
  lifted.torque[0].phase = 1.6;
  expect_refused(lifted, "loads act on it");
  MotionSpec slope = lying(coulomb(0.1));
  slope.gravity = Vec3(5.0, 0.0, -9.0);
  expect_refused(slope, "gravity pulls it along");
  slope.friction->mu = 0.6;
  EXPECT_EQ(integrated(disc_body(), slope, 1e-9).record.events.back().event, "lies_flat");
  MotionSpec carried = lying(coulomb(0.1));
  carried.friction->turntable = 0.01;
  expect_refused(carried, "the table turns");
  MotionSpec damped = lying(coulomb(0.1));
  damped.torque = {damping("spin", 0.01)};
  EXPECT_EQ(integrated(disc_body(), damped, 1e-9).record.events.back().event, "lies_flat");
}

// A ball at rest is turned for an instant whenever two torques that beat against each other exceed
// what moments against boring hold, which no error of its steps tells. Held against I dw/dt alone,
// in a million steps.
TEST(LoadsOnATable, TurnABodyAtRestForAnInstantOnly) {
  constexpr double kTorque = 0.001, kBoring = 0.001;
  const BodySpec ball = ball_body(0.05, 0.2);
  MotionSpec spec = on_table(20.0, coulomb(0.3));
  spec.friction->boring = kBoring;
  for (const double rate : {5.0, 6.0}) {
    LoadSpec load = load_of("constant");
    load.space = Vec3(0, 0, kTorque);
    load.rate = rate;
    load.phase = -8.0 * rate;
    spec.torque.push_back(load);
  }
  constexpr int kSteps = 1'000'000;
  const double h = spec.duration / kSteps, held = kBoring * 0.2 * kG;
  double w = 0.0, turned = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) * h - 8.0;
    const double torque = kTorque * (std::cos(5.0 * t) + std::cos(6.0 * t));
    const double after = std::max(0.0, w + h * (torque - held) / (0.4 * 0.2 * 0.05 * 0.05));
    turned += 0.5 * h * (w + after);
    w = after;
  }
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const State end = integrated(ball, spec, tolerance).trajectory->at(20.0);
    EXPECT_NEAR(2.0 * std::asin(std::abs(end.q.z())), turned, 1e-6 * turned) << tolerance;
  }
}

// A ball at rest is pushed harder than friction can hold it at rest, while moments against rolling
// and boring hold it too: where both give way it rolls, and does not slip. The end was found by two
// other programs, one with events and one with laws of friction that are smooth.
TEST(LoadsOnATable, RollABallThatMomentsOfBothKindsHold) {
  MotionSpec spec = on_table(0.1, coulomb(0.4));
  spec.friction->rolling = spec.friction->boring = 0.001;
  LoadSpec push = load_of("force");
  push.space = Vec3(4.0, 0.0, 0.0);
  push.at = Vec3(0.0, 0.01, 0.0);
  spec.torque = {push};
  const Simulation found = simulated(ball_body(0.1, 1.0), spec);
  const Quat right(0.9973957175, -3.0e-8, 0.0696156356, -0.0188532757);
  EXPECT_LT(rotation_angle_between(found.motion.at(0.1).q_SB, right), 1e-8);
  EXPECT_TRUE(found.motion.contact_at(0.05)->touch.sticks);
}

// A disc at rest leans and is pushed: what gives way alone takes from the others what they need, or
// gives them more, so that nothing but rolling grows in its direction. The end was found by another
// program with smooth laws of friction, extrapolated to sharp ones.
TEST(LoadsOnATable, LetGoOnlyWhatGrows) {
  MotionSpec spec = on_table(0.5, coulomb(0.2494));
  spec.friction->rolling = 0.011361;
  spec.friction->boring = 0.000103;
  spec.attitude.quaternion = Eigen::Vector4d(0.160468, -0.233184, 0.841355, 2.719275);
  LoadSpec push = load_of("force");
  push.space = Vec3(-0.20186, -0.88961, -0.12897);
  push.at = Vec3(0.0161, -0.0194, 0.0211);
  spec.torque = {push};
  const Simulation found = simulated(disc_body(0.0951, 0.258), spec);
  const Quat right(-0.37243321, 0.00984358, -0.00410722, 0.92799771);
  EXPECT_LT(rotation_angle_between(found.motion.at(0.5).q_SB, right), 1e-6);
}

// What rolls back and forth turns without coming to rest where its load is greatest: what it has
// across its way stays. The end was found by another program with smooth laws of friction.
TEST(LoadsOnATable, RollABallBackAndForth) {
  MotionSpec spec = on_table(1.0, coulomb(0.5));
  spec.friction->rolling = 0.001;
  LoadSpec push = load_of("force");
  push.space = Vec3(2.0, 0.0, 0.0);
  push.at = Vec3(0.0, 0.01, 0.0);
  push.rate = 30.0;
  spec.torque = {push};
  const Simulation found = simulated(ball_body(0.1, 1.0), spec, 1e-5);
  const Quat right(0.99998139585, 8.167384e-05, -0.005620967905, -0.002367699192);
  EXPECT_LT(rotation_angle_between(found.motion.at(1.0).q_SB, right), 1e-5);
  EXPECT_TRUE(found.report.reliability.doubts.empty());
}

// steps that loads would make too many are refused before the first of them
TEST(LoadsOnATable, TooFastForTheDurationAreRefusedAtOnce) {
  MotionSpec spec = on_table(20.0, coulomb(0.3));
  LoadSpec load = load_of("constant");
  load.space = Vec3(0, 0, 1e-4);
  load.rate = 1e8;
  spec.torque = {load};
  expect_error([&] { integrated(ball_body(), spec, 1e-6); },
               Fault::input,
               "",
               "needs at least about 4e+09 steps for 20 s");
}

}  // namespace
}  // namespace polhode::test
