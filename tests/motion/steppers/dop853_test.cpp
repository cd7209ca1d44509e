// SPDX-License-Identifier: MIT
// Dormand and Prince's method of order 8: what its table must satisfy, seen from outside.
#include <cmath>

#include <gtest/gtest.h>

#include "support/residual.h"
#include "support/stepping.h"
#include "support/taylor_oracle.h"

namespace polhode::test {
namespace {

// order 8 on the sphere, an equation with constant coefficients: the angle of a step is off by the
// ninth power of the step, which tells every digit of the table that matters there
TEST(Dop853, TurnsASphereToTheNinthPowerOfTheStep) {
  const auto error = [](double turn) {
    return std::abs(turn_of_sphere("dop853", turn) - turn);
  };
  EXPECT_NEAR(std::log2(error(2.0) / error(1.0)), 9.0, 0.15);
  expect_residual("dop853 short step", error(0.1), 1e-15);
}

// HNW II.10, eq. 10.17: errors of order 5 and 3 are combined such that the whole is of order 8
TEST(Dop853, ItsEstimateIsOfOrderEight) {
  const Problem p = hairer_vilmart();
  const auto estimate = [&](double h) {
    State s = p.start;
    Work work;
    const double error = stepper("dop853", p)->step_with_error(0.0, h, s, work);
    EXPECT_EQ(work.evaluations, 12);
    return error;
  };
  EXPECT_NEAR(std::log2(estimate(0.2) / estimate(0.1)), 8.0, 0.3);
}

// R0c: stable below 5.9 on the imaginary axis, about
TEST(Dop853, R0cIsUnstableBeyondSix) {
  EXPECT_LT(transverse_growth("dop853", 5.0, 1000), 1.0);
  EXPECT_FALSE(transverse_growth("dop853", 6.5, 1000) < 10.0);  // it ends beyond all numbers
}

}  // namespace
}  // namespace polhode::test
