// SPDX-License-Identifier: MIT
#include "model/loads.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "math/so3.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

using test::expect_input_error;

const Mat3 kAxes = from_xyz_turns({0.3, -0.4, 0.8});
const Vec3 kCenter(0.1, -0.2, 0.3);

Loads loads_of(const std::vector<LoadSpec>& specs, bool on_pivot = false) {
  return make_loads(specs,
                    on_pivot,
                    kCenter,
                    on_pivot ? Vec3(Vec3::Zero()) : kCenter,
                    kAxes,
                    Vec3(1.0, 2.0, 2.5));
}

LoadSpec load(const std::string& kind) {
  LoadSpec spec;
  spec.kind = kind;
  return spec;
}

const Quat kAttitude = exp_rotation({0.5, 1.1, -0.7});

Wrench wrench(const Loads& loads, double t = 0.0, const Vec3& place = Vec3::Zero()) {
  return wrench_of(loads.turning, t, kAttitude, Vec3(1, 2, 3), Vec3(0.5, -1, 2), place);
}

TEST(Loads, TorqueInEitherAxes) {
  LoadSpec in_space = load("constant");
  in_space.space = Vec3(1, -2, 0.5);
  EXPECT_LT((kAttitude * wrench(loads_of({in_space})).torque_P - *in_space.space).norm(), 1e-15);
  LoadSpec in_body = load("constant");
  in_body.body = Vec3(1, -2, 0.5);
  EXPECT_LT((kAxes * wrench(loads_of({in_body})).torque_P - *in_body.body).norm(), 1e-15);
  // they add up
  const Vec3 both = wrench(loads_of({in_space, in_body})).torque_P;
  EXPECT_LT(
      (both - wrench(loads_of({in_space})).torque_P - wrench(loads_of({in_body})).torque_P).norm(),
      1e-15);
}

TEST(Loads, ChangeAsACosine) {
  LoadSpec spec = load("constant");
  spec.body = Vec3(0, 0, 2.0);
  spec.rate = 3.0;
  spec.phase = 0.4;
  EXPECT_NEAR((kAxes * wrench(loads_of({spec}), 1.7).torque_P).z(), 2.0 * std::cos(5.5), 1e-15);
  // a phase alone is a factor
  spec.rate.reset();
  EXPECT_NEAR((kAxes * wrench(loads_of({spec}), 1.7).torque_P).z(), 2.0 * std::cos(0.4), 1e-15);
}

TEST(Loads, DampingOfMomentumAndOfSpin) {
  LoadSpec spec = load("damping");
  spec.c = 0.7;
  const Loads momentum = loads_of({spec, spec});
  EXPECT_TRUE(momentum.only_damp_momentum());
  EXPECT_EQ(momentum.momentum_damping(), 1.4);
  EXPECT_LT((wrench(momentum).torque_P + 1.4 * Vec3(1, 2, 3)).norm(), 1e-15);
  spec.of = "spin";
  EXPECT_FALSE(loads_of({spec}).only_damp_momentum());
  EXPECT_LT((wrench(loads_of({spec})).torque_P + 0.7 * Vec3(0.5, -1, 2)).norm(), 1e-15);
}

// notes, eq. 22: tau about another point differs by a x F
TEST(Loads, ForceHasItsArmFromTheReferencePoint) {
  LoadSpec spec = load("force");
  spec.space = Vec3(1, 2, -1);
  spec.at = Vec3(0.4, 0.1, 0.2);
  for (const bool on_pivot : {false, true}) {
    const Vec3 reference = on_pivot ? Vec3(Vec3::Zero()) : kCenter;
    const Vec3 arm_S = kAttitude * (kAxes.transpose() * (*spec.at - reference));
    const Loads loads = loads_of({spec}, on_pivot);
    EXPECT_LT((kAttitude * wrench(loads).torque_P - arm_S.cross(*spec.space)).norm(), 1e-15);
    EXPECT_EQ(loads.pushes.size(), on_pivot ? 0u : 1u);
    EXPECT_FALSE(loads.need_place);
  }
  // at the centre of mass it does not turn the body
  spec.at.reset();
  EXPECT_TRUE(loads_of({spec}).turning.empty());
  // fixed in the body it goes where the body points
  spec.body = *spec.space;
  spec.space.reset();
  const Loads turning = loads_of({spec});
  EXPECT_TRUE(turning.need_place);
  EXPECT_LT((wrench(turning).force_S - kAttitude * (kAxes.transpose() * *spec.body)).norm(), 1e-15);
}

// the couple is the same whatever it is reduced to
TEST(Loads, CoupleDependsOnTheDistanceOfItsPointsOnly) {
  LoadSpec spec = load("couple");
  spec.space = Vec3(1, 2, -1);
  spec.at = Vec3(0.4, 0.1, 0.2);
  spec.opposite = Vec3(-0.1, 0.3, 0.0);
  LoadSpec moved = spec;
  moved.at = *spec.at + Vec3(5, -3, 2);
  moved.opposite = *spec.opposite + Vec3(5, -3, 2);
  for (const bool on_pivot : {false, true}) {
    const Loads loads = loads_of({spec}, on_pivot);
    EXPECT_TRUE(loads.pushes.empty());
    EXPECT_FALSE(loads.need_place);
    EXPECT_LT((wrench(loads).torque_P - wrench(loads_of({moved}, on_pivot)).torque_P).norm(),
              1e-14);
    EXPECT_EQ(wrench(loads).force_S, Vec3::Zero());
  }
}

// forces and torques are the slopes of the potential (notes, eqs. 24 and 25)
TEST(Loads, PotentialHasTheRightSlopes) {
  LoadSpec spring = load("spring");
  spring.k = 3.0;
  spring.length = 0.5;
  spring.at = Vec3(0.4, 0.1, 0.2);
  spring.to = Vec3(1, 1, 2);
  LoadSpec force = load("force");
  force.space = Vec3(1, 2, -1);
  force.at = Vec3(0.4, 0.1, 0.2);
  LoadSpec couple = load("couple");
  couple.space = Vec3(1, 2, -1);
  couple.at = Vec3(0.4, 0.1, 0.2);
  couple.opposite = Vec3(-0.1, 0.3, 0.0);
  const Vec3 place(0.2, -0.3, 0.1);
  const double h = 1e-5;
  for (const LoadSpec& spec : {spring, force, couple}) {
    SCOPED_TRACE(spec.kind);
    const Loads loads = loads_of({spec});
    ASSERT_TRUE(loads.turning.at(0).conservative());
    const Wrench w = wrench(loads, 0.0, place);
    for (int i = 0; i < 3; ++i) {
      const Vec3 turn = h * Vec3::Unit(i);
      const double slope = (potential_of(loads.turning, exp_rotation(turn) * kAttitude, place) -
                            potential_of(loads.turning, exp_rotation(-turn) * kAttitude, place)) /
                           (2 * h);
      EXPECT_NEAR(slope, -(kAttitude * w.torque_P)[i], 1e-8);
      if (spec.kind != "spring") continue;
      const double pull = (potential_of(loads.turning, kAttitude, place + turn) -
                           potential_of(loads.turning, kAttitude, place - turn)) /
                          (2 * h);
      EXPECT_NEAR(pull, -w.force_S[i], 1e-8);
    }
  }
}

// way and speed of a push, against sums over small steps, through slow and fast changes
TEST(Pushes, WayAndSpeedAreIntegrals) {
  for (const double rate : {0.0, 1e-9, 1e-4, 0.3, 20.0}) {
    const Push push{Vec3(0, 0, 2.0), rate, 0.7};
    const double t = 1.9;
    double speed = 0.0, way = 0.0;
    const int steps = 20000;
    const double h = t / steps;
    for (int i = 0; i < steps; ++i) {
      const double force = 2.0 * std::cos(rate * (i + 0.5) * h + 0.7);
      way += speed * h + 0.5 * force * h * h;
      speed += force * h;
    }
    EXPECT_NEAR(speed_of(push, t).z(), speed, 2e-7) << rate;
    EXPECT_NEAR(way_of(push, t).z(), way, 2e-7) << rate;
  }
  // both forms meet where one gives way to the other
  const Push below{Vec3(0, 0, 1), 0.999999e-3, 0.7}, above{Vec3(0, 0, 1), 1.000001e-3, 0.7};
  EXPECT_NEAR(way_of(below, 1.0).z(), way_of(above, 1.0).z(), 1e-9);
}

TEST(LoadErrors, NameTheKey) {
  const auto refuse = [](const LoadSpec& spec, const std::string& key, const std::string& words) {
    expect_input_error([&] { loads_of({load("damping"), spec}); }, key, words);
  };
  LoadSpec damping = load("damping");
  damping.c = 1.0;
  const auto second = [&](const LoadSpec& spec, const std::string& key, const std::string& words) {
    expect_input_error([&] { loads_of({damping, spec}); }, key, words);
  };
  refuse(damping, "motion.torque[0]", "needs 'c'");
  second(load("sprng"), "motion.torque[1].kind", "did you mean 'spring'?");
  second(load("constant"), "motion.torque[1]", "needs 'space' or 'body'");
  second(load("spring"), "motion.torque[1]", "needs 'k'");
  LoadSpec couple = load("couple");
  couple.at = Vec3::Zero();
  couple.space = Vec3::UnitX();
  second(couple, "motion.torque[1]", "needs 'opposite'");
  couple.opposite = couple.at;
  second(couple, "motion.torque[1].opposite", "cancel");
  LoadSpec wrong = load("constant");
  wrong.body = Vec3::UnitX();
  wrong.k = 1.0;
  second(wrong, "motion.torque[1].k", "has no 'k'; it takes rate, phase, space, body");
}

}  // namespace
}  // namespace polhode
