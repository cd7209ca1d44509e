// SPDX-License-Identifier: MIT
#include "math/bracketed_zero.h"

#include <random>

#include <gtest/gtest.h>

namespace polhode {
namespace {

// zeros anywhere in the bracket, also within a rounding of its ends, of functions of all slopes
TEST(BracketedZero, IsEnclosedWhereverItIs) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int i = 0; i < 20'000; ++i) {
    const double high = std::pow(10.0, 6.0 * part(random) - 3.0);
    const double from_end = std::pow(10.0, -17.0 * part(random));
    const double zero = high * (i % 2 == 0 ? from_end : 1.0 - from_end);
    const double bend = 10.0 * part(random), size = std::pow(10.0, 20.0 * part(random) - 10.0);
    const double sign = i % 3 == 0 ? -1.0 : 1.0;
    int calls = 0;
    const auto f = [&](double x) {
      ++calls;
      const double away = (x - zero) / high;
      return sign * size * away * (1.0 + bend * away * away);
    };
    const Bracket whole{0.0, high, f(0.0), f(high)};
    if (whole.at_high == 0.0) continue;
    const Bracket found = narrowed(whole, 0.0, f);
    EXPECT_LE(found.high - found.low, 1e-15 * high) << zero << ' ' << high;
    EXPECT_LE(found.low, zero);
    EXPECT_GE(found.high, zero);
    EXPECT_LT(calls, 60) << zero << ' ' << high;
  }
}

// nothing that a function may return keeps it from coming to an end
TEST(BracketedZero, EndsForFunctionsThatAreNone) {
  int calls = 0;
  const auto jump = [&](double x) {
    ++calls;
    return x < 0.3 ? 1e300 : -1e-300;
  };
  const Bracket found = narrowed({0.0, 1.0, jump(0.0), jump(1.0)}, 0.0, jump);
  EXPECT_NEAR(found.low, 0.3, 1e-15);
  EXPECT_NEAR(found.high, 0.3, 1e-15);
  EXPECT_LT(calls, 300);
  const auto nan = [&](double) {
    return std::numeric_limits<double>::quiet_NaN();
  };
  EXPECT_LE(narrowed({0.0, 1.0, 1.0, -1.0}, 0.0, nan).high, 1.0);
}

}  // namespace
}  // namespace polhode
