// SPDX-License-Identifier: MIT
// The limits that are warned of and drawn into maps are where methods really end.
#include "motion/step_limit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "motion/stepper_table.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

// Landau and Lifshitz, Mechanics, 33 and 37
TEST(OscillationRate, IsThatOfEulersEquations) {
  const BodyModel symmetric = free_body({1, 1, 2});
  EXPECT_DOUBLE_EQ(oscillation_rate(symmetric, {Quat::Identity(), {1, 0, 4}}), 2.0);
  const BodyModel asymmetric = free_body({1, 2, 3});
  const double w = 0.7;
  EXPECT_NEAR(oscillation_rate(asymmetric, {Quat::Identity(), {1e-6, 0, 3 * w}}),
              w * std::sqrt(2.0 * 1.0 / (1.0 * 2.0)),
              1e-9);
  EXPECT_NEAR(oscillation_rate(asymmetric, {Quat::Identity(), {1 * w, 1e-6, 0}}),
              w * std::sqrt(1.0 * 2.0 / (2.0 * 3.0)),
              1e-9);
  EXPECT_EQ(oscillation_rate(free_body({1, 1, 1}), {Quat::Identity(), {1, 2, 3}}), 0.0);
}

// momentum across the axis after many steps, over that at the start; infinite without a solution
double growth(const StepperInfo& method, const Problem& p, double h) {
  const std::unique_ptr<Stepper> stepper = method.make(p.model, p.start.y.norm());
  State s = p.start;
  try {
    for (int i = 0; i < 3000; ++i)
      stepper->step(0.0, h, s);
  } catch (const Error&) {
    return INFINITY;
  }
  const double across = s.y.head<2>().norm();
  return std::isfinite(across) ? across / p.start.y.head<2>().norm() : INFINITY;
}

TEST(StepLimit, IsWhereTheMethodEnds) {
  // tilted, so that angles exist
  const Problem p{free_body({1, 1, 2}), {exp_rotation({0.9, 0, 0}), {1e-6, 0, 4}}};
  int limits = 0;
  for (const StepperInfo& row : stepper_table()) {
    const double h = step_limit(row, p.model, p.start);
    if (!std::isfinite(h) || row.name == "rk4_euler_angles") continue;
    ++limits;
    EXPECT_LT(growth(row, p, 0.9 * h), 1.0 + 1e-6) << row.name;
    EXPECT_GT(growth(row, p, 1.1 * h), 1.2) << row.name;
  }
  EXPECT_GE(limits, 4);
}

}  // namespace
}  // namespace polhode::test
