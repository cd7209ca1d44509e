// SPDX-License-Identifier: MIT
#include "motion/conditioning.h"

#include <gtest/gtest.h>

#include "motion/derived.h"
#include "motion/simulate.h"
#include "support/expect_error.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;

SimulationReport report_of(const BodyModel& model, const Vec3& w_B, double duration) {
  MotionSpec spec;
  spec.duration = duration;
  spec.spin.body = w_B;
  return simulate(model, spec, {}, 1e-6).report;
}

TEST(Conditioning, NeighboursDifferInOneNumberEach) {
  const State start{exp_rotation({0.1, 0.2, 0.3}), {1.0, 2.0, 3.0}};
  const std::vector<State> neighbours = neighbours_of(start, 1e-6).starts;
  ASSERT_EQ(neighbours.size(), 6U);
  for (const State& s : neighbours) {
    const double turned = rotation_angle_between(s.q, start.q);
    const double changed = (s.y - start.y).norm() / start.y.norm();
    EXPECT_NEAR(std::max(turned, changed), 1e-6, 1e-12);
    EXPECT_NEAR(std::min(turned, changed), 0.0, 1e-12);
  }
  EXPECT_NEAR(rotation_angle_between(
                  one_neighbour_of(free_body({1, 2, 3}), start, 1e-6).starts[0].q, start.q),
              1e-6 * std::sqrt(3.0),
              1e-12);
}

// A spin about the middle axis lasts only as long as round-off lets it, however its axes are
// written.
TEST(Conditioning, TheMiddleAxisIsDoubtedInAnyAxes) {
  const BodyModel model = free_body({1, 2, 3});
  MotionSpec turned;
  turned.duration = 60.0;
  turned.attitude.zxz = Vec3(0, 0.5 * kPi, 0);
  turned.spin.space = Vec3(0, 0, 10);
  MotionSpec plain;
  plain.duration = 60.0;
  plain.spin.body = Vec3(0, 10, 0);
  for (const MotionSpec& spec : {turned, plain})
    EXPECT_FALSE(simulate(model, spec, {}, 1e-4).report.reliability.doubts.empty());
  // the other axes are safe
  plain.spin.body = Vec3(0, 0, 10);
  EXPECT_TRUE(simulate(model, plain, {}, 1e-4).report.reliability.doubts.empty());
}

// a centre of mass that rests between two springs that push
TEST(Conditioning, UnstablePlacesAreDoubted) {
  BodySpec body;
  body.moments = Vec3(1, 1, 1);
  MotionSpec spec;
  spec.duration = 20.0;
  spec.position = Vec3(0.5, 0, 0);
  LoadSpec spring;
  spring.kind = "spring";
  spring.k = 10.0;
  spring.length = 1.0;
  spec.torque = {spring, spring};
  spec.torque[1].to = Vec3(1, 0, 0);
  const BodyModel model = make_model(body, spec);
  bool doubted = false;
  try {
    doubted = !simulate(model, spec, {}, 1e-3).report.reliability.doubts.empty();
  } catch (const Error&) {
    doubted = true;  // refused
  }
  EXPECT_TRUE(doubted);
}

// a free sphere: a change of the rate by one part grows with the angle turned
TEST(Conditioning, GrowsWithTheTurnsOfASphere) {
  const SimulationReport report = report_of(free_body({1, 1, 1}), {0, 0, 2.0}, 1000.0);
  ASSERT_TRUE(report.conditioning);
  EXPECT_GT(report.conditioning->effect, 0.5 * 2000.0 * 0x1p-53);
  EXPECT_LT(report.conditioning->effect, 4.0 * 2000.0 * 0x1p-53);
  EXPECT_FALSE(report.conditioning->exceeds_limit);
  EXPECT_TRUE(report.reliability.doubts.empty());
}

// Near the separatrix neighbours part while the body flips, and are together again between: looks
// at even times, of which there are as many as flips, would see nothing.
TEST(Conditioning, IsSeenWhateverTheNumberOfFlips) {
  const BodyModel model = free_body({1, 2, 3});
  MotionSpec spec;
  spec.duration = 1.0;
  spec.spin.body = Vec3(1e-9, 1.0, 0.0);
  const double flip = value_of(derived_quantities(model, spec), "flip_time_s").value();
  for (const int flips : {100, 128, 256, 512}) {
    const SimulationReport report = report_of(model, spec.spin.body.value(), flips * flip);
    EXPECT_TRUE(report.conditioning->exceeds_limit) << flips;
  }
}

// from its start on, the separatrix leaves a neighbour as exp(growth t)
TEST(Conditioning, SeparatrixIsDoubted) {
  const SimulationReport report = report_of(free_body({1, 2, 3}), {std::sqrt(3.0), 1.0, 1.0}, 60.0);
  ASSERT_TRUE(report.conditioning);
  EXPECT_TRUE(report.conditioning->exceeds_limit);
  EXPECT_GT(report.conditioning->effect, 1e-6);
  EXPECT_GT(report.conditioning->exceeded_at, 1.0);
  ASSERT_EQ(report.reliability.doubts.size(), 1U);
  EXPECT_NE(report.reliability.doubts[0].find("separatrix"), std::string::npos);
}

// a pendulum that is let go, for 1e13 s: off by 2.6e-3 rad against 50 digits
TEST(Conditioning, ManyTurnsAreDoubted) {
  BodyModel model = heavy_body({0.14, 0.14, 0.02}, Vec3(0, 0, 0.3 * 9.80665));
  MotionSpec spec;
  spec.hold = "pivot";
  spec.attitude.zxz = Vec3(0.1, 0.7, 0.2);
  for (const double duration : {1e3, 1e9, 1e13}) {
    spec.duration = duration;
    const SimulationReport report = simulate(model, spec, {}, 1e-4).report;
    EXPECT_EQ(report.method, "exact");
    EXPECT_GT(report.conditioning->effect, duration * 2.6e-16);
    EXPECT_LT(report.conditioning->effect, duration * 1e-14);
    EXPECT_EQ(report.reliability.doubts.empty(), duration < 1e11) << duration;
    EXPECT_EQ(report.conditioning->exceeds_limit, duration > 1e11) << duration;
  }
}

// the last digits of an attitude are not rounded away
TEST(Conditioning, NeighboursOfTheLastDigitsAreOthers) {
  const State start{exp_rotation({0.1, 0.2, 0.3}), {1.0, 2.0, 3.0}};
  for (const State& s : neighbours_of(start, 0x1p-49).starts) {
    const double turned = (s.q.coeffs() - start.q.coeffs()).norm();
    const double changed = (s.y - start.y).norm() / start.y.norm();
    EXPECT_GT(std::max(turned, changed), 0.2 * 0x1p-49);
    EXPECT_LT(std::max(turned, changed), 1.5 * 0x1p-49);
  }
}

TEST(Conditioning, IsNotDoubtedAwayFromIt) {
  EXPECT_TRUE(report_of(free_body({1, 2, 3}), {1.0, 0.3, 0.5}, 60.0).reliability.doubts.empty());
}

}  // namespace
}  // namespace polhode
