// SPDX-License-Identifier: MIT
// Starts that are given in the words of mechanics.
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "math/so3.h"
#include "motion/derived.h"
#include "motion/simulate.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

// a wooden cone on its tip, with its axis along z
BodySpec cone() {
  BodySpec spec;
  spec.solid.emplace();
  spec.solid->kind = "cone";
  spec.solid->radius = 0.04;
  spec.solid->height = 0.05;
  spec.solid->mass = 0.06;
  return spec;
}

MotionSpec on_pivot(double tilt) {
  MotionSpec spec;
  spec.hold = "pivot";
  spec.duration = 20.0;
  spec.attitude.tilt = tilt;
  return spec;
}

double derived(const BodyModel& model, const MotionSpec& spec, const std::string& name) {
  for (const Quantity& quantity : derived_quantities(model, spec)) {
    if (quantity.name == name) return quantity.value;
  }
  ADD_FAILURE() << "no " << name;
  return 0.0;
}

// nothing but precession: the tilt stays, and the axis goes round at the rate that inspect tells
TEST(StartWords, SteadyPrecessionHasNoNutation) {
  for (const double tilt : {0.3, 1.2, 0.5 * kPi, 2.4}) {
    for (const char* which : {"slow", "fast"}) {
      SCOPED_TRACE(std::string(which) + " at " + std::to_string(tilt));
      MotionSpec spec = on_pivot(tilt);
      spec.spin.steady = which;
      spec.spin.axial = 190.0;
      const BodyModel model = make_model(cone(), spec);
      if (tilt == 0.5 * kPi && std::string(which) == "fast") {
        test::expect_input_error(
            [&] { start_state(model, spec); }, "motion.spin.steady", "has no fast");
        continue;
      }
      const Motion motion = simulate(model, spec, {}, 1e-9).motion;
      const double rate = derived(model, spec, std::string(which) + "_steady_precession");
      for (const double t : {0.0, 0.37, 20.0}) {
        const Sample now = motion.at(t);
        const Vec3 axis = now.q_SB * Vec3::UnitZ();
        EXPECT_NEAR(std::acos(axis.z()), tilt, 2e-8) << t;
        EXPECT_NEAR(now.w_B.z(), 190.0, 1e-9);
        // Omega = rate Z + spin about the axis
        EXPECT_NEAR((now.w_S - rate * Vec3::UnitZ()).cross(axis).norm(), 0.0, 1e-9) << t;
      }
    }
  }
}

TEST(StartWords, SteadyPrecessionIsForFirmGround) {
  MotionSpec spec = on_pivot(0.5);
  spec.spin.steady = "slow";
  spec.spin.axial = 190.0;
  spec.frame_rotation = Vec3(0.5, 0.0, 0.6);
  test::expect_input_error([&] { start_state(make_model(cone(), spec), spec); },
                           "motion.spin.steady",
                           "in a space that does not turn");
}

TEST(StartWords, BelowItsThresholdNoPrecessionIsSteady) {
  MotionSpec spec = on_pivot(0.3);
  spec.spin.steady = "slow";
  spec.spin.axial = 50.0;
  const BodyModel model = make_model(cone(), spec);
  std::string words;
  try {
    start_state(model, spec);
  } catch (const Error& error) {
    EXPECT_EQ(error.place().key, "motion.spin.axial");
    words = error.message();
  }
  const std::size_t at = words.find("below ");
  ASSERT_NE(at, std::string::npos) << words;
  const double least = std::stod(words.substr(at + 6));
  spec.spin.axial = least * (1.0 - 1e-5);
  EXPECT_THROW(start_state(model, spec), Error);
  spec.spin.axial = least * (1.0 + 1e-5);
  EXPECT_NO_THROW(start_state(model, spec));
}

// a pendulum that goes round without spin; a level axis falls without it
TEST(StartWords, WithoutSpinAHangingTopGoesRound) {
  MotionSpec spec = on_pivot(2.0);
  spec.spin.steady = "slow";
  spec.spin.axial = 0.0;
  const BodyModel model = make_model(cone(), spec);
  const Motion motion = simulate(model, spec, {}, 1e-9).motion;
  for (const double t : {0.0, 0.37, 20.0})
    EXPECT_NEAR((motion.at(t).q_SB * Vec3::UnitZ()).z(), std::cos(2.0), 2e-9) << t;
  EXPECT_GT(motion.at(0.0).w_S.norm(), 1.0);
  spec.attitude.tilt = 0.5 * kPi;
  test::expect_input_error(
      [&] { start_state(model, spec); }, "motion.spin.axial", "a level axis without spin falls");
  spec.attitude.tilt = 1.0;
  test::expect_input_error([&] { start_state(model, spec); }, "motion.spin.axial", "below ");
}

TEST(StartWords, ASleepingTopStandsUpright) {
  MotionSpec spec = on_pivot(0.0);
  spec.spin.sleeping = 190.0;
  const BodyModel model = make_model(cone(), spec);
  const Motion motion = simulate(model, spec, {}, 1e-9).motion;
  EXPECT_LE((motion.at(20.0).w_S - Vec3(0, 0, 190)).norm(), 1e-9);
  spec.attitude.tilt = 0.01;
  test::expect_input_error([&] { start_state(model, spec); }, "motion.spin.sleeping", "upright");
  // a body that is no such top
  MotionSpec free;
  free.spin.sleeping = 1.0;
  test::expect_input_error([&] { start_state(make_model(cone(), free), free); },
                           "motion.spin.sleeping",
                           "symmetric top");
  MotionSpec alone = on_pivot(0.1);
  alone.spin.axial = 3.0;
  test::expect_input_error(
      [&] { start_state(model, alone); }, "motion.spin.axial", "is for steady");
}

TEST(StartWords, TheMomentumCanPointUp) {
  BodySpec body;
  body.moments = Vec3(1, 2, 3);
  for (const bool as_momentum : {false, true}) {
    MotionSpec spec;
    spec.attitude.momentum_up = true;
    (as_momentum ? spec.spin.momentum_body : spec.spin.body) = Vec3(0.3, -2.0, 0.4);
    const BodyModel model = make_model(body, spec);
    const Motion motion = simulate(model, spec, {}, 1e-9).motion;
    for (const double t : {0.0, 5.0}) {
      const Vec3 L = motion.at(t).L_S;
      EXPECT_LE(L.cross(Vec3::UnitZ()).norm(), 1e-12 * L.norm());
      EXPECT_GT(L.z(), 0.0);
    }
    EXPECT_LE((motion.at(0.0).w_B - (as_momentum ? Vec3(0.3, -1.0, 0.4 / 3) : Vec3(0.3, -2.0, 0.4)))
                  .norm(),
              1e-14);
  }
  MotionSpec wrong;
  wrong.attitude.momentum_up = true;
  wrong.spin.space = Vec3(1, 0, 0);
  const BodyModel model = make_model(body, wrong);
  const auto start = [&] {
    start_state(model, wrong);
  };
  test::expect_input_error(start, "motion.attitude.momentum_up", "needs a spin in body axes");
  wrong.spin = {};
  wrong.spin.body = Vec3::Zero();
  test::expect_input_error(start, "motion.attitude.momentum_up", "at rest");
  wrong.attitude.momentum_up = false;
  test::expect_input_error(start, "motion.attitude.momentum_up", "must be true");
}

}  // namespace
}  // namespace polhode
