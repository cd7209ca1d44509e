// SPDX-License-Identifier: MIT
#include "motion/walk.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/stepping.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

// Counts the time in y[0]; its error is that of a method of order 2, or what is wanted of it.
class Clock : public Stepper {
 public:
  void step(double, double h, State& s, Work& work) const override {
    s.y[0] += h;
    ++work.evaluations;
  }
  double step_with_error(double t, double h, State& s, Work& work) const override {
    step(t, h, s, work);
    if (t + h > bad_after) s.y[1] = std::nan("");
    return t + h > stuck_after ? 1.0 : h * h;
  }

  double bad_after = std::numeric_limits<double>::infinity();
  double stuck_after = std::numeric_limits<double>::infinity();
};

StepperInfo of_order(int order) {
  StepperInfo row;
  row.name = "clock";
  row.order = order;
  return row;
}

TEST(WalkFixed, VisitsEveryStepInOrder) {
  State s;
  long last = 0;
  const WalkRecord record = walk_fixed(Clock(), s, 0.25, 8, [&](long i, const State& now) {
    EXPECT_EQ(i, ++last);
    EXPECT_EQ(now.y[0], 0.25 * static_cast<double>(i));
  });
  EXPECT_EQ(record.steps, 8);
  EXPECT_EQ(record.work.evaluations, 8);
  EXPECT_EQ(s.y[0], 2.0);
  EXPECT_EQ(walk_fixed(Clock(), s, 0.25, 0, kLookAway).steps, 0);
}

TEST(WalkAdaptive, EndsAtTheDurationAndStaysBelowTheTolerance) {
  State s;
  double last = 0.0;
  const WalkRecord record =
      walk_adaptive(of_order(2), Clock(), s, 1.0, 1e-4, 0.3, {}, [&](double t, const State& now) {
        EXPECT_LE((t - last) * (t - last), 1e-4);
        EXPECT_NEAR(now.y[0], t, 1e-15 * 200);
        last = t;
      });
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(record.work.evaluations, record.steps + record.rejected);
  // 0.3 is too long, 0.03 after it is too, and 0.009 not; then 0.009 is kept: 0.9 of the longest
  EXPECT_EQ(record.rejected, 2);
  EXPECT_EQ(record.steps, 112);
}

TEST(WalkAdaptive, NeverGrowsByMoreThanFive) {
  State s;
  std::vector<double> times = {0.0};
  walk_adaptive(of_order(2), Clock(), s, 1.0, 1e6, 1e-3, {}, [&](double t, const State&) {
    times.push_back(t);
  });
  ASSERT_GE(times.size(), 5U);
  EXPECT_NEAR(times[2] - times[1], 5e-3, 1e-15);
  EXPECT_NEAR(times[3] - times[2], 25e-3, 1e-15);
}

// steps end within a few roundings of a switch on both sides, and go on as long as before
TEST(WalkAdaptive, LandsBesideSwitches) {
  State s;
  std::vector<double> times = {0.0};
  walk_adaptive(
      of_order(2), Clock(), s, 1.0, 1e-2, 0.09, {0.2, 0.5, 3.0}, [&](double t, const State&) {
        times.push_back(t);
      });
  EXPECT_EQ(times.back(), 1.0);
  for (const double at : {0.2, 0.5}) {
    const auto behind = std::upper_bound(times.begin(), times.end(), at);
    EXPECT_NEAR(*behind, at, 1e-15);
    EXPECT_NEAR(*(behind - 1), at, 1e-15);
    EXPECT_NEAR(*(behind + 1) - *behind, 0.09, 1e-3);
  }
}

TEST(WalkAdaptive, RefusesNaNAndAToleranceThatCannotBeReached) {
  Clock bad;
  bad.bad_after = 0.5;
  State s;
  expect_error([&] { walk_adaptive(of_order(2), bad, s, 1.0, 1e-2, 0.05, {}, kLookAway); },
               Fault::check_failed,
               "",
               "the motion is not a number at t = 0.5");
  Clock stuck;
  stuck.stuck_after = 0.5;
  State at_start;
  expect_error([&] { walk_adaptive(of_order(2), stuck, at_start, 1.0, 1e-2, 0.05, {}, kLookAway); },
               Fault::check_failed,
               "",
               "clock cannot reach tolerance 0.01 at t = 0.5");
}

TEST(IsFinite, LooksAtEveryPart) {
  EXPECT_TRUE(is_finite(State()));
  for (int part = 0; part < 4; ++part) {
    State s;
    double& number = part == 0   ? s.q.coeffs()[2]
                     : part == 1 ? s.y[1]
                     : part == 2 ? s.place_S[0]
                                 : s.linear_momentum_S[2];
    number = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(is_finite(s)) << part;
    expect_error([&] { refuse_nan(s, of_order(2), 3.5); },
                 Fault::check_failed,
                 "",
                 "not a number at t = 3.5 s with method clock");
  }
  EXPECT_NO_THROW(refuse_nan(State(), of_order(2), 0.0));
}

}  // namespace
}  // namespace polhode::test
