// SPDX-License-Identifier: MIT
#include "motion/grid_trajectory.h"

#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "motion/scales.h"
#include "motion/stepper_table.h"
#include "motion/walk.h"
#include "support/expect_error.h"
#include "support/residual.h"
#include "support/stepper_rows.h"
#include "support/taylor_oracle.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;

Integration integration_of(const std::string& method, double duration) {
  const Problem p = heavy_asymmetric();
  const StepperInfo& row = find_stepper(method);
  return row.adaptive ? integrate_adaptive(row, p.model, p.start, duration, 1e-8)
                      : integrate_fixed(row, p.model, p.start, duration, 0.01);
}

std::vector<double> mixed_times(double duration) {
  std::vector<double> times;
  for (int i = 0; i < 400; ++i)
    times.push_back(duration * std::fmod(0.618033988749895 * i, 1.0));
  times.push_back(0.0);
  times.push_back(duration);
  return times;
}

using EveryTrajectory = StepperTest;
INSTANTIATE_TEST_SUITE_P(Table, EveryTrajectory, every_stepper(), stepper_name);

TEST_P(EveryTrajectory, SameBitsInAnyOrderAndFromTwoThreads) {
  const auto trajectory = integration_of(GetParam().name, 5.0).trajectory;
  const std::vector<double> times = mixed_times(5.0);
  std::vector<State> forward(times.size()), backward(times.size()), other(times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    forward[i] = trajectory->at(times[i]);
  std::thread helper([&] {
    for (std::size_t i = 0; i < times.size(); ++i)
      other[i] = trajectory->at(times[i]);
  });
  for (std::size_t i = times.size(); i-- > 0;)
    backward[i] = trajectory->at(times[i]);
  helper.join();
  const auto again = integration_of(GetParam().name, 5.0).trajectory;
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_TRUE(same_bits(forward[i], backward[i]));
    EXPECT_TRUE(same_bits(forward[i], other[i]));
    EXPECT_TRUE(same_bits(forward[i], again->at(times[i])));
  }
}

TEST_P(EveryTrajectory, StartsWithTheStartAndIsContinuousAtGridTimes) {
  const auto trajectory = integration_of(GetParam().name, 2.0).trajectory;
  EXPECT_TRUE(same_bits(trajectory->at(0.0), heavy_asymmetric().start));
  double jump = 0.0;
  for (int i = 1; i <= 200; ++i) {
    const double t = 0.01 * i;
    jump = worse(jump, distance(trajectory->at(std::nextafter(t, 0.0)), trajectory->at(t)));
  }
  expect_residual("jump at grid times", jump, 4e-15);
}

// more steps than states are kept: at() walks, and gives the very states that were stepped
TEST(Stride, WalkingGivesTheSameBitsAsStepping) {
  const Problem p = hairer_vilmart();
  const StepperInfo& row = find_stepper("rk4");
  const long n = 350'001;
  const double h = 1e-3;
  const Integration found = integrate_fixed(row, p.model, p.start, n * h, h);
  EXPECT_EQ(found.record.steps, n);
  EXPECT_EQ(found.record.evaluations, 4 * n);

  const std::unique_ptr<Stepper> stepper = row.make(p.model, 1.0);
  State s = p.start;
  int compared = 0;
  for (long i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) * h;
    if (i % 9973 == 0 || i == n || i == n - 1) {
      // the time itself may round to just before the grid time: then a whole step is taken
      EXPECT_LE(distance(found.trajectory->at(t), s), 1e-15) << "step " << i;
      compared += same_bits(found.trajectory->at(t), s) ? 1 : 0;
    }
    stepper->step(t, h, s);
  }
  EXPECT_GE(compared, 30);
}

// an adaptive run of more steps than states are kept
TEST(Stride, WalkingAnAdaptiveGridGivesTheSameStates) {
  const Problem p = hairer_vilmart();
  const StepperInfo& row = find_stepper("dopri5");
  constexpr double kTolerance = 1e-14;
  const double duration = 1600.0;
  const Integration found = integrate_adaptive(row, p.model, p.start, duration, kTolerance);
  ASSERT_GT(found.record.steps, 400'000);
  const std::unique_ptr<Stepper> stepper = row.make(p.model, momentum_scale(p.model, p.start));
  State s = p.start;
  long step = 0;
  walk_adaptive(row,
                *stepper,
                s,
                duration,
                kTolerance,
                first_step(p.model, p.start, kTolerance, row.order),
                {},
                [&](double t, const State& now) {
                  if (++step % 9973 != 0) return;
                  EXPECT_TRUE(same_bits(found.trajectory->at(t), now)) << "step " << step;
                });
}

TEST(FixedSteps, ADurationThatIsNoMultipleOfTheStepIsReached) {
  const Problem p = hairer_vilmart();
  const auto found = integrate_fixed(find_stepper("rk4"), p.model, p.start, 1.0, 0.003);
  EXPECT_EQ(found.record.steps, 333);
  expect_residual("end of an odd duration",
                  distance(found.trajectory->at(1.0), TaylorOracle(p.model, p.start).at(1.0L)),
                  3e-11);
  // one step longer than the whole motion is a single partial step
  const auto one = integrate_fixed(find_stepper("rk4"), p.model, p.start, 0.01, 0.5);
  EXPECT_EQ(one.record.steps, 0);
  EXPECT_LE(distance(one.trajectory->at(0.01), TaylorOracle(p.model, p.start).at(0.01L)), 1e-9);
}

TEST(Effort, IsToldHowFarARunIs) {
  const Problem p = hairer_vilmart();
  std::vector<double> parts;
  Effort effort;
  effort.watch = [&](double part) {
    parts.push_back(part);
  };
  integrate_fixed(find_stepper("rk4"), p.model, p.start, 20.0, 0.001, effort);
  EXPECT_EQ(parts.size(), 4U);
  integrate_adaptive(find_stepper("dopri5"), p.model, p.start, 100.0, 1e-13, effort);
  EXPECT_GT(parts.size(), 6U);
  for (const double part : parts) {
    EXPECT_GT(part, 0.0);
    EXPECT_LE(part, 1.0);
  }
}

TEST(Effort, HasALimit) {
  const Problem p = hairer_vilmart();
  const StepperInfo& rk4 = find_stepper("rk4");
  EXPECT_EQ(integrate_fixed(rk4, p.model, p.start, 1.0, 0.01, {100}).record.steps, 100);
  expect_input_error(
      [&] { integrate_fixed(rk4, p.model, p.start, 1.0, 0.01, {99}); }, "", "at most 99");
}

TEST(FixedSteps, TooManyAreRefusedBeforeAnyIsTaken) {
  const Problem p = hairer_vilmart();
  expect_input_error(
      [&] { integrate_fixed(find_stepper("rk4"), p.model, p.start, 1e9, 1e-3); }, "", "at most");
}

TEST(FixedSteps, ABlowUpIsReportedWithItsTime) {
  const Problem p = hairer_vilmart();
  expect_error(
      [&] { integrate_fixed(find_stepper("explicit_euler"), p.model, p.start, 100.0, 0.1); },
      Fault::check_failed,
      "",
      "not a number at t = 5");
}

// as far as frames show it
TEST(FixedSteps, DriftIsTheLargestWithinLongStepsToo) {
  const BodyModel model = free_body({0.99, 1.97, 1.33});
  State start;
  start.y = Vec3(-2.4, -4.75, -17.5);
  for (const double duration : {0.77, 1.5, 5.0}) {
    const Integration found = integrate_fixed(find_stepper("cf4"), model, start, duration, 0.98);
    DriftWatch shown(model, start);
    for (int i = 0; i <= 1000; ++i)
      shown.look_at(found.trajectory->at(duration * i / 1000.0));
    const double told = found.record.drift.energy.value(), most = shown.worst().energy.value();
    EXPECT_GT(most, 0.01) << duration;
    EXPECT_NEAR(told, most, 0.05 * most) << duration;
  }
}

// A step may have a solution where a part of it has none.
TEST(FixedSteps, AreKnownWithinWhereverTheyHaveASolution) {
  const BodyModel model = free_body({1.0, 2.0, 3.0});
  State start;
  start.y = Vec3(0.05, 18.0, 0.15);
  const StepperInfo& midpoint = find_stepper("implicit_midpoint");
  constexpr double kStep = 0.5;
  const auto found = integrate_fixed(midpoint, model, start, 2.0 * kStep, kStep).trajectory;
  const auto stepper = midpoint.make(model, momentum_scale(model, start));
  int without = 0;
  for (double t = 0.001; t < kStep; t += 0.001) {
    State part = start;
    try {
      stepper->step_within(0.0, t, kStep, part);
      EXPECT_TRUE(same_bits(found->at(t), part)) << t;
    } catch (const Error&) {
      ++without;
    }
    EXPECT_NEAR(found->at(t).y.norm(), start.y.norm(), 1e-10) << t;
    EXPECT_NEAR(energy(model, found->at(t)), energy(model, start), 1e-8) << t;
  }
  EXPECT_GT(without, 10);
  EXPECT_LT(without, 400);
}

TEST(AdaptiveSteps, ErrorFollowsTheToleranceAndDriftIsRecorded) {
  const Problem p = heavy_asymmetric();
  const State exact = TaylorOracle(p.model, p.start).at(10.0L);
  double before = 1.0;
  for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
    const Integration found =
        integrate_adaptive(find_stepper("dopri5"), p.model, p.start, 10.0, tolerance);
    const double error = distance(found.trajectory->at(10.0), exact);
    expect_residual(fmt::format("dopri5 tolerance {:g}", tolerance), error, 300 * tolerance);
    EXPECT_LT(error, 0.1 * before);
    EXPECT_GT(found.record.drift.energy.value(), 1e-3 * error);
    EXPECT_GT(found.record.steps, 0);
    EXPECT_EQ(found.record.evaluations, 7 * (found.record.steps + found.record.rejected));
    before = error;
  }
}

TEST(AdaptiveSteps, ToleranceBelowRoundOffIsReported) {
  const Problem p = heavy_asymmetric();
  expect_input_error(
      [&] { integrate_adaptive(find_stepper("dopri5"), p.model, p.start, 10.0, 1e-17); },
      "",
      "below the round-off");
  // at round-off itself the work is bounded
  EXPECT_LE(integrate_adaptive(find_stepper("dopri5"), p.model, p.start, 1.0, 1e-16).record.steps,
            20'000);
}

TEST(AdaptiveSteps, ABodyAtRestTakesOneStep) {
  const BodyModel model = free_body({0.6, 0.8, 1.0});
  const State rest;
  const Integration found = integrate_adaptive(find_stepper("dopri5"), model, rest, 10.0, 1e-8);
  EXPECT_EQ(found.record.steps, 1);
  EXPECT_TRUE(same_bits(found.trajectory->at(7.0), rest));
}

}  // namespace
}  // namespace polhode
