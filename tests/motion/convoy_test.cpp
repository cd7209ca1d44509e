// SPDX-License-Identifier: MIT
// Motions that step together: the same bits as alone, the same errors, each call once.
#include "motion/convoy.h"

#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "motion/grid_trajectory.h"
#include "motion/scales.h"
#include "motion/simulate.h"
#include "motion/steppers/lanes.h"
#include "motion/walk.h"
#include "support/stepping.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

// a motion, and how finely it is integrated
struct Traveller {
  Problem problem;
  double duration, tolerance;
};

// heavy, free and tilted bodies of all kinds, each with a length and a tolerance of its own
std::vector<Traveller> travellers(int count) {
  std::mt19937 numbers(7);
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  const auto vector = [&] {
    return Vec3(even(numbers), even(numbers), even(numbers));
  };
  std::vector<Traveller> found;
  for (int i = 0; i < count; ++i) {
    const Vec3 moments = Vec3(1.0, 1.3, 1.6) + 0.2 * vector();
    const BodyModel model =
        i % 5 == 4 ? free_body(moments)
                   : heavy_body(moments, 2.0 * vector(), (Vec3::UnitZ() + vector()).normalized());
    const State start{exp_rotation(3.0 * vector()), 3.0 * vector()};
    found.push_back({{model, start}, 3.0 + 2.0 * even(numbers), std::pow(10.0, -5 - i % 9)});
  }
  return found;
}

// every bit of a walk: times and states
std::vector<std::uint64_t> bits_of_walk(const Traveller& one) {
  const StepperInfo& method = find_stepper("dop853");
  const auto& [model, start] = one.problem;
  const std::unique_ptr<Stepper> stepper = method.make(model, momentum_scale(model, start));
  State s = start;
  std::vector<std::uint64_t> bits;
  const auto add = [&](double x) {
    bits.push_back(std::bit_cast<std::uint64_t>(x));
  };
  const WalkRecord record = walk_adaptive(
      method, *stepper, s, one.duration, one.tolerance, 0.7, {}, [&](double t, const State& now) {
        add(t);
        for (const double x : now.q.coeffs())
          add(x);
        for (const double x : now.y)
          add(x);
        // a step by itself among the stretches of others
        State beside = now;
        Work work;
        add(stepper->step_with_error(t, 0.01, beside, work));
        add(beside.y.x());
      });
  add(static_cast<double>(record.steps));
  add(static_cast<double>(record.rejected));
  add(static_cast<double>(record.work.evaluations));
  return bits;
}

TEST(Convoy, MotionsHaveTheBitsThatTheyHaveAlone) {
  const std::vector<Traveller> all = travellers(45);
  std::vector<std::vector<std::uint64_t>> together(all.size());
  std::atomic<bool> was_in_convoy = false;
  parallel_in_convoys(static_cast<long>(all.size()), 2, [&](long i) {
    if (in_convoy()) was_in_convoy = true;
    together[static_cast<std::size_t>(i)] = bits_of_walk(all[static_cast<std::size_t>(i)]);
  });
  EXPECT_FALSE(in_convoy());
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_TRUE(was_in_convoy);
#endif
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_EQ(together[i], bits_of_walk(all[i])) << "motion " << i;
}

// refined, compared and judged
TEST(Convoy, SimulationsEndAsTheyDoAlone) {
  const BodyModel model = heavy_asymmetric().model;
  NumericsSpec numerics;
  numerics.method = "dop853";
  const auto solve = [&](long i) {
    MotionSpec motion;
    motion.hold = "pivot";
    motion.duration = 5.0;
    motion.spin.body = Vec3(1.0, 0.1 * static_cast<double>(i), 2.0);
    return simulate(model, motion, numerics, 1e-7);
  };
  constexpr long kMotions = 12;
  std::vector<std::optional<Simulation>> together(kMotions);
  parallel_in_convoys(
      kMotions, 1, [&](long i) { together[static_cast<std::size_t>(i)] = solve(i); });
  for (long i = 0; i < kMotions; ++i) {
    const Simulation alone = solve(i);
    const Simulation& other = together[static_cast<std::size_t>(i)].value();
    EXPECT_EQ(alone.report.tolerance, other.report.tolerance);
    EXPECT_EQ(alone.report.record.steps, other.report.record.steps);
    EXPECT_EQ(alone.report.error_estimate_rad, other.report.error_estimate_rad);
    EXPECT_EQ(alone.report.conditioning->effect, other.report.conditioning->effect);
    EXPECT_EQ(alone.report.reliability.doubts, other.report.reliability.doubts);
  }
}

// steps of one motion that have nothing to do with each other: as many as registers and more
TEST(Convoy, LeapsAreSteps) {
  for (const Traveller& one : travellers(5)) {
    const std::unique_ptr<Stepper> stepper = find_stepper("dop853").make(one.problem.model, 1.0);
    for (const int count : {0, 1, 3, 8, 13, 150}) {
      std::vector<State> states(static_cast<std::size_t>(count)), alone;
      std::vector<Leap> leaps;
      for (State& s : states) {
        const double h = 0.003 * (static_cast<double>(leaps.size()) - 40.5);
        s = one.problem.start;
        s.y.x() += 10.0 * h;
        alone.push_back(s);
        stepper->step(0.0, h, alone.back());
        leaps.push_back({0.0, h, h, &s});
      }
      stepper->leap(leaps.data(), count);
      for (std::size_t i = 0; i < states.size(); ++i) {
        EXPECT_EQ(states[i].q.coeffs(), alone[i].q.coeffs());
        EXPECT_EQ(states[i].y, alone[i].y);
      }
    }
  }
}

// one that is not a number fails as it does alone, and the others arrive
TEST(Convoy, AMotionThatFailsSaysWhatItSaysAlone) {
  std::vector<Traveller> all = travellers(9);
  all[3].problem.start.y.x() = std::nan("");
  const auto words = [&](std::size_t i) -> std::string {
    try {
      bits_of_walk(all[i]);
    } catch (const Error& error) {
      return error.what();
    }
    return "arrived";
  };
  std::vector<std::string> together(all.size());
  parallel_in_convoys(9, 1, [&](long i) {
    together[static_cast<std::size_t>(i)] = words(static_cast<std::size_t>(i));
  });
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_EQ(together[i], words(i));
  EXPECT_NE(together[3], "arrived");
}

TEST(Convoy, EachCallIsMadeOnce) {
  for (const long count : {0L, 1L, 7L, 8L, 9L, 100L}) {
    std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
    parallel_in_convoys(count, 2, [&](long i) { ++calls[static_cast<std::size_t>(i)]; });
    for (const std::atomic<int>& number : calls)
      EXPECT_EQ(number, 1);
  }
}

// calls that run end, no other is made
TEST(Convoy, TheFirstErrorEndsTheLoop) {
  std::atomic<int> calls = 0;
  const std::vector<Traveller> all = travellers(8);
  EXPECT_THROW(parallel_in_convoys(1000,
                                   1,
                                   [&](long i) {
                                     ++calls;
                                     if (i == 2) throw input_error("enough");
                                     bits_of_walk(all[static_cast<std::size_t>(i % 8)]);
                                   }),
               Error);
  EXPECT_LE(calls, kLanes);
}

// the equations in registers of any width against those of one motion; the processor of the test
// may have none of that width
template <class Wide>
void expect_lanes_are_numbers() {
  constexpr std::size_t kWidth = sizeof(Wide) / sizeof(double);
  std::mt19937 numbers(3);
  std::uniform_real_distribution<double> even(-2.0, 2.0);
  HeavyBody<Wide> body;
  WideVector<Wide> v, rate;
  std::array<HeavyBody<double>, kWidth> bodies;
  std::array<WideVector<double>, kWidth> alone;
  for (std::size_t lane = 0; lane < kWidth; ++lane) {
    for (std::size_t i = 0; i < 3; ++i) {
      body.inverse_moments[i][lane] = bodies[lane].inverse_moments[i] = 2.5 + even(numbers);
      body.chi[i][lane] = bodies[lane].chi[i] = even(numbers);
      body.up[i][lane] = bodies[lane].up[i] = even(numbers);
    }
    for (std::size_t i = 0; i < 7; ++i)
      v.of[i][lane] = alone[lane].of[i] = even(numbers);
  }
  heavy_rate(body, v.of.data(), rate.of.data());
  normalize(v);
  for (std::size_t lane = 0; lane < kWidth; ++lane) {
    WideVector<double> of_one;
    heavy_rate(bodies[lane], alone[lane].of.data(), of_one.of.data());
    normalize(alone[lane]);
    for (std::size_t i = 0; i < 7; ++i) {
      EXPECT_EQ(rate.of[i][lane], of_one.of[i]);
      EXPECT_EQ(v.of[i][lane], alone[lane].of[i]);
    }
  }
}
TEST(Convoy, LanesOfAnyWidthAreNumbers) {
  expect_lanes_are_numbers<TwoLanes>();
  expect_lanes_are_numbers<FourLanes>();
  expect_lanes_are_numbers<EightLanes>();
}

}  // namespace
}  // namespace polhode::test
