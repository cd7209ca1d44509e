// SPDX-License-Identifier: MIT
#include "motion/reliability.h"

#include <gtest/gtest.h>

#include "motion/motion.h"
#include "motion/simulate.h"
#include "support/loads.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

SimulationReport report_of(const char* method, double step, double accuracy) {
  NumericsSpec numerics;
  numerics.method = method;
  numerics.step = step;
  return simulate(free_body({1, 2, 3}), spun({0.4, -0.1, 3.0}, 20.0), numerics, accuracy).report;
}

TEST(Reliability, IsLostWithTheInvariants) {
  const Reliability reliability = report_of("explicit_euler", 0.02, 1.0).reliability;
  ASSERT_GE(reliability.doubts.size(), 2U);
  EXPECT_NE(reliability.doubts[0].find("energy"), std::string::npos);
  EXPECT_NE(reliability.doubts[1].find("L drifts"), std::string::npos);
}

// the invariants may be perfect and the motion wrong
TEST(Reliability, IsLostAgainstTheClosedForm) {
  const SimulationReport report = report_of("implicit_midpoint", 0.2, 1e-3);
  ASSERT_EQ(report.reliability.doubts.size(), 1U);
  EXPECT_NE(report.reliability.doubts[0].find("the attitude is off"), std::string::npos);
  EXPECT_GT(report.reliability.attitude_error_rad.value(), 1e-2);
  EXPECT_LT(report.record.drift.energy.value(), 1e-12);
}

TEST(Reliability, HoldsForWhatIsExactEnough) {
  const SimulationReport report = report_of("rk4", 0.002, 1e-4);
  EXPECT_TRUE(report.reliability.doubts.empty());
  EXPECT_LT(report.reliability.attitude_error_rad.value(), 1e-4);
}

// A rod with a speck of dust, which turns end over end: its moments differ by 9e-13 of the largest,
// but that acts on the least of them.
TEST(Reliability, CountsMomentsAsEqualOnlyWhereThatTurnsNothing) {
  const auto end_of = [](const Vec3& moments, const MotionSpec& motion, const char* method) {
    const BodyModel model = make_model(body_with(moments), motion);
    NumericsSpec numerics;
    numerics.method = method;
    const Simulation found = simulate(model, motion, numerics, 1e-3);
    EXPECT_TRUE(found.report.reliability.doubts.empty()) << method;
    return found.motion.at(motion.duration).w_B;
  };
  const Vec3 rod(0.08333333333333333, 0.08333333333340833, 5e-7);
  const MotionSpec over = spun({10, 10, 0}, 100.0);
  const Vec3 right(9.2232, 10.7206, -0.0014965);  // another program's DOP853
  for (const char* method : {"auto", "dop853", "taylor16"})
    EXPECT_LT((end_of(rod, over, method) - right).norm(), 0.02) << method;

  // where it turns nothing the body counts as symmetric
  EXPECT_TRUE(make_model(body_with({1, 1 + 9e-13, 1.3}), spun({1, 0, 5}, 1.0)).kind.symmetric());
  EXPECT_FALSE(
      make_model(body_with({1, 1 + 9e-13, 1e-6}), spun({1, 1, 0}, 100.0)).kind.symmetric());
  // round-off of the moments themselves is told
  const MotionSpec fast = spun({100, 100, 0.0}, 100.0);
  const BodyModel needle = make_model(body_with({1, 1 + 2e-15, 1e-8}), fast);
  EXPECT_TRUE(needle.kind.symmetric());
  EXPECT_FALSE(simulate(needle, fast, {}, 1e-4).report.reliability.doubts.empty());
}

// a centre of mass that is given is that far from the pivot, however little that is
TEST(Reliability, ShortLeversAct) {
  BodySpec body = body_with({1, 2, 2.5});
  body.center_of_mass = Vec3(0, 0, 9e-15);
  MotionSpec motion;
  motion.hold = "pivot";
  motion.gravity = Vec3(10, 0, 0);
  motion.duration = 1e6;
  const Simulation found = simulate(make_model(body, motion), motion, {}, 1e-6);
  const double turned = 2.0 * found.motion.at(1e6).q_SB.vec().norm();
  EXPECT_NEAR(turned, 0.0225, 5e-5);
}

TEST(Reliability, LongStepsAreToldBeforehand) {
  const Problem p{free_body({1, 1, 2}), {Quat::Identity(), {0.1, 0, 4}}};  // limit sqrt 2
  NumericsSpec numerics;
  numerics.method = "rk4";
  numerics.step = 1.42;
  const std::optional<std::string> words = step_beyond_limit(p.model, p.start, numerics);
  ASSERT_TRUE(words);
  EXPECT_NE(words->find("1.41 s"), std::string::npos) << *words;
  numerics.step = 1.41;
  EXPECT_FALSE(step_beyond_limit(p.model, p.start, numerics));
  numerics.method = "rkmk4";  // theory has no limit
  numerics.step = 100.0;
  EXPECT_FALSE(step_beyond_limit(p.model, p.start, numerics));
}

TEST(Reliability, BackwardTurningIsTold) {
  const double quarter_per_frame = 0.5 * kPi * 60.0;
  EXPECT_FALSE(turns_backwards(1.99 * quarter_per_frame, 1.0 / 60.0));
  const std::optional<std::string> words = turns_backwards(3.0 * quarter_per_frame, 1.0 / 60.0);
  ASSERT_TRUE(words);
  EXPECT_NE(words->find("270 degrees"), std::string::npos) << *words;
}

}  // namespace
}  // namespace polhode::test
