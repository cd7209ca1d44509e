// SPDX-License-Identifier: MIT
// Every outcome on a motion that deserves it.
#include "chart/stability.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/step_limit.h"
#include "motion/stepper_table.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

constexpr double kAllowed = 0.1;

StabilityProblem problem(const Problem& p, double duration) {
  return {p.model, p.start, duration};
}

StabilityCell tried(const char* method, const StabilityProblem& p, double h) {
  return try_method(find_stepper(method), p, h, kAllowed);
}

TEST(Stability, OutcomesHaveNames) {
  for (int v = 0; v < kRunOutcomes; ++v)
    EXPECT_EQ(find_run_outcome(name_of(static_cast<RunOutcome>(v))), static_cast<RunOutcome>(v));
  EXPECT_FALSE(find_run_outcome("fien"));
}

TEST(Stability, FineAndThenOutOfPhase) {
  const StabilityProblem p = problem({free_body({1, 1, 2}), {Quat::Identity(), {1, 0, 4}}}, 100.0);
  const StabilityCell fine = tried("rk4", p, 0.05);
  EXPECT_EQ(fine.outcome, RunOutcome::fine);
  EXPECT_LT(fine.error_rad, kAllowed);
  EXPECT_EQ(tried("implicit_midpoint", p, 0.2).outcome, RunOutcome::phase_wrong);
}

// R0: below 2 sqrt 2 the classical method loses energy, beyond it gains
TEST(Stability, EnergyDecaysBelowTheLimitAndGrowsBeyond) {
  const StabilityProblem p = problem({free_body({1, 1, 2}), {Quat::Identity(), {1, 0, 4}}}, 400.0);
  const double limit = step_limit(find_stepper("rk4"), p.model, p.start);
  EXPECT_NEAR(limit, std::sqrt(2.0), 1e-6);
  const StabilityCell below = tried("rk4", p, 0.95 * limit), beyond = tried("rk4", p, 1.05 * limit);
  EXPECT_EQ(below.outcome, RunOutcome::energy_decays);
  EXPECT_LT(below.energy_drift, 0.0);
  EXPECT_EQ(beyond.outcome, RunOutcome::energy_grows);
  EXPECT_GT(beyond.energy_drift, 0.0);
}

// long steps keep energy and momentum, and turn the body over at the wrong times
TEST(Stability, FlipsWrongly) {
  const StabilityProblem p =
      problem({free_body({1, 2, 3}), {Quat::Identity(), {0.01, 2.0, 0.01}}}, 200.0);
  EXPECT_EQ(tried("implicit_midpoint", p, 1.0).outcome, RunOutcome::flips_wrongly);
}

TEST(Stability, SolverFailedAndNotANumber) {
  const StabilityProblem p =
      problem({free_body({1, 2, 3}), {Quat::Identity(), {0.1, 0.1, 3}}}, 100.0);
  EXPECT_EQ(tried("dmv2", p, 1.1).outcome, RunOutcome::solver_failed);
  EXPECT_NE(tried("dmv2", p, 0.9).outcome, RunOutcome::solver_failed);
  const StabilityProblem fast =
      problem({free_body({1, 2, 3}), {Quat::Identity(), {40, 50, 60}}}, 1000.0);
  const StabilityCell lost = tried("explicit_euler", fast, 1.0);
  EXPECT_EQ(lost.outcome, RunOutcome::not_a_number);
  EXPECT_TRUE(std::isnan(lost.error_rad));
}

// a step that is longer than the run counts as one of its length, though parts of it have solutions
TEST(Stability, AStepLongerThanTheRunMayHaveNoSolution) {
  const StabilityProblem p =
      problem({free_body({1, 1.3, 1.6}), {Quat::Identity(), {1, 7.8, 3.2}}}, 0.49);
  for (const double step : {0.3, 0.85, 2.4})
    EXPECT_EQ(tried("dmv2", p, step).outcome, RunOutcome::solver_failed) << step;
  EXPECT_NE(tried("dmv2", p, 0.1).outcome, RunOutcome::solver_failed);
  EXPECT_NE(tried("rk4", p, 2.4).outcome, RunOutcome::solver_failed);
}

// without a reference the invariants speak
TEST(Stability, WithoutAReferenceInvariantsDecide) {
  const StabilityProblem p = problem({heavy_body({0.6, 0.8, 1.0}, {0.3, -0.5, 0.7}),
                                      {exp_rotation({0.4, 1.1, -0.3}), {0.3, 0.1, -0.2}}},
                                     1500.0);
  ASSERT_TRUE(std::isinf(p.reference.uncertainty()));
  const StabilityCell kept = tried("gauss6", p, 0.2), lost = tried("rk4", p, 0.5);
  EXPECT_EQ(kept.outcome, RunOutcome::fine);
  EXPECT_TRUE(std::isnan(kept.error_rad));
  EXPECT_NE(lost.outcome, RunOutcome::fine);
}

}  // namespace
}  // namespace polhode::test
