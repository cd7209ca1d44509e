// SPDX-License-Identifier: MIT
#include "motion/reliability.h"

#include <gtest/gtest.h>

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
