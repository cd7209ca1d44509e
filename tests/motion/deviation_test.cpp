// SPDX-License-Identifier: MIT
#include "motion/deviation.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "math/so3.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

TEST(Deviation, IsTheAngleOrTheWayInRadiiOfGyration) {
  BodyModel model = free_body({1, 2, 4});
  model.body.mass = 1.0;
  State a, b;
  b.q = exp_rotation({0, 0.3, 0});
  b.place_S = Vec3(0, 0, 1.0);  // half a radius of gyration, sqrt(4 / 1)
  EXPECT_NEAR(deviation(model, a, b), 0.3, 1e-15);
  model.with_translation = true;
  EXPECT_NEAR(deviation(model, a, b), 0.5, 1e-15);
  b.q = exp_rotation({0, 0.7, 0});
  EXPECT_NEAR(deviation(model, a, b), 0.7, 1e-15);
}

TEST(Deviation, KeepsNaN) {
  BodyModel model = free_body({1, 2, 4});
  State bad;
  bad.q.coeffs()[0] = std::nan("");
  EXPECT_TRUE(std::isnan(deviation(model, State(), bad)));
  model.with_translation = true;
  EXPECT_TRUE(std::isnan(deviation(model, State(), bad)));
  State lost;
  lost.place_S[1] = std::nan("");
  EXPECT_TRUE(std::isnan(deviation(model, State(), lost)));
}

// turns about z at this rate; the attitude is lost after `lost` seconds
class Turning final : public Trajectory {
 public:
  explicit Turning(double rate, double lost = 100.0) : rate_(rate), lost_(lost) {}
  State at(double t) const override {
    State s;
    s.q = exp_rotation({0, 0, rate_ * t});
    if (t > lost_) s.q.coeffs()[0] = std::nan("");
    return s;
  }

 private:
  double rate_, lost_;
};

TEST(Deviation, LargestOfTwoMotions) {
  const BodyModel model = free_body({1, 2, 4});
  EXPECT_NEAR(largest_deviation(model, Turning(1.0), Turning(1.1), {0.0, 2.0, 1.0}), 0.2, 1e-14);
  EXPECT_TRUE(
      std::isnan(largest_deviation(model, Turning(1.0), Turning(1.0, 1.5), {0.0, 2.0, 1.0})));
}

// keeps its state at every multiple of a step
class Stepping final : public Trajectory {
 public:
  explicit Stepping(double step) : step_(step) {}
  State at(double) const override { return {}; }
  std::vector<double> kept_times(const std::vector<double>& times) const override {
    std::vector<double> kept;
    for (const double t : times)
      kept.push_back(step_ * std::floor(t / step_));
    return kept;
  }

 private:
  double step_;
};

TEST(CheapTimes, AreThoseThatAMotionKeepsIfItKeepsEnough) {
  const std::vector<double> times = {0.0, 0.3, 0.4, 1.3, 2.9, 3.1, 3.5};
  EXPECT_EQ(cheap_times(Stepping(1.0), times), (std::vector<double>{0, 1, 2, 3, 3.5}));
  EXPECT_EQ(cheap_times(Stepping(100.0), times), (std::vector<double>{0, 3.5}));
  std::vector<double> many(100);
  for (std::size_t i = 0; i < many.size(); ++i)
    many[i] = 0.01 * static_cast<double>(i);
  EXPECT_EQ(cheap_times(Stepping(0.1), many), many);
  EXPECT_EQ(cheap_times(Turning(1.0), times), times);
  EXPECT_TRUE(cheap_times(Stepping(1.0), {}).empty());
}

TEST(ScatteredTimes, FillTheDurationAndHaveNoPeriod) {
  const std::vector<double> times = scattered_times(12.0, 100);
  ASSERT_EQ(times.size(), 102U);
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_EQ(times.back(), 12.0);
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  // of the part of a period at which each lies, every tenth is met, whatever the period
  for (const double period : {0.012, 0.12, 12.0 / 89.0, 1.0}) {
    std::vector<int> met(10);
    for (const double t : times)
      ++met[static_cast<std::size_t>(std::fmod(t, period) / period * 10.0) % 10];
    EXPECT_GT(*std::min_element(met.begin(), met.end()), 0) << period;
  }
}

TEST(TimesAfterSwitches, AreInPulsesAndBehindThem) {
  EXPECT_TRUE(times_after_switches({}, 10.0).empty());
  const std::vector<double> times = times_after_switches({5.0, 5.02, 20.0}, 10.0);
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  const auto within = [&](double from, double to) {
    return std::count_if(
        times.begin(), times.end(), [&](double t) { return t >= from && t <= to; });
  };
  EXPECT_GE(within(5.0, 5.02), 12);
  EXPECT_GE(within(5.02, 5.13), 12) << "a hundredth of the duration";
  EXPECT_LE(times.back(), 10.0);
}

TEST(ScatteredTimes, DependOnTheSeed) {
  const std::vector<double> some = scattered_times(1.0, 50), others = scattered_times(1.0, 50, 1);
  EXPECT_EQ(some, scattered_times(1.0, 50));
  for (std::size_t i = 1; i <= 50; ++i)
    EXPECT_NE(some[i], others[i]);
}

}  // namespace
}  // namespace polhode::test
