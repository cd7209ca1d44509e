// SPDX-License-Identifier: MIT
// Random tops and starts for property tests (RapidCheck): sizes over many decades, shapes up to
// degenerate ones.
#pragma once

#include <cmath>
#include <random>

// rapidcheck/gtest.h needs it before
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "math/so3.h"
#include "support/tops.h"

namespace polhode::test {

// A number in low..high; RapidCheck shrinks towards low.
inline double number_between(double low, double high) {
  constexpr int kSteps = 1'000'000;
  // the whole range from the first try on
  const int step = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, kSteps + 1));
  return low + (high - low) * step / kSteps;
}

inline Vec3 vector_within(double size) {
  return {number_between(-size, size), number_between(-size, size), number_between(-size, size)};
}

inline Quat any_attitude() {
  return exp_rotation(vector_within(3.0));
}

// Moments that a real body has, from sphere to needle and disc, of any size: sums of second
// moments.
inline Vec3 any_moments() {
  const double size = std::pow(10.0, number_between(-6.0, 6.0));
  const double a = 1.0, b = std::pow(10.0, number_between(-2.0, 0.0));
  const double c = std::pow(10.0, number_between(-2.0, 0.0));
  return size * Vec3(b + c, a + c, a + b);
}

// A momentum that turns a body of these moments by about one radian per second.
inline Vec3 any_momentum(const Vec3& moments) {
  return moments.cwiseProduct(vector_within(1.5));
}

}  // namespace polhode::test
