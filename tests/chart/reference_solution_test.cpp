// SPDX-License-Identifier: MIT
#include "chart/reference_solution.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/grid_trajectory.h"
#include "motion/stepper_table.h"
#include "support/residual.h"
#include "support/taylor_oracle.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

TEST(ReferenceSolution, KnowsBodiesWithAClosedForm) {
  const Problem p = hairer_vilmart();
  const ReferenceSolution reference(p.model, p.start, 10.0);
  EXPECT_EQ(reference.source(), "closed form (asymmetric)");
  EXPECT_LT(reference.uncertainty(), 1e-13);
  const State truth = TaylorOracle(p.model, p.start).at(10.0L);
  expect_residual("reference at the end", reference.error_at_end(truth), reference.uncertainty());
}

TEST(ReferenceSolution, IsTwoMethodsThatAgreeElsewhere) {
  const Problem p = heavy_asymmetric();
  const ReferenceSolution reference(p.model, p.start, 5.0);
  EXPECT_EQ(reference.source(), "dop853 and kick_srkn11 agree");
  EXPECT_LT(reference.uncertainty(), 1e-11);
  const State truth = TaylorOracle(p.model, p.start).at(5.0L);
  expect_residual(
      "reference at the end", reference.error_at_end(truth), reference.uncertainty() + 1e-12);
}

// errors come out as they are: of a run with a known one, and over the whole motion
TEST(ReferenceSolution, MeasuresErrors) {
  const Problem p = hairer_vilmart();
  const ReferenceSolution reference(p.model, p.start, 4.0);
  const StepperInfo& rk4 = find_stepper("rk4");
  const Integration run = integrate_fixed(rk4, p.model, p.start, 4.0, 0.1);
  TaylorOracle oracle(p.model, p.start);
  double worst = 0.0;
  for (int i = 0; i <= 64; ++i) {
    const double t = 4.0 * i / 64.0;
    worst = std::max(worst, rotation_angle_between(run.trajectory->at(t).q, oracle.at(t).q));
  }
  EXPECT_GT(worst, 1e-6);
  EXPECT_NEAR(reference.error_of(*run.trajectory), worst, 1e-13);
}

// a chaotic top for long: two methods part, and nobody knows
TEST(ReferenceSolution, SaysWhenThereIsNone) {
  const Problem p{heavy_body({0.6, 0.8, 1.0}, {0.3, -0.5, 0.7}),
                  {exp_rotation({0.4, 1.1, -0.3}), {0.3, 0.1, -0.2}}};
  const ReferenceSolution reference(p.model, p.start, 1500.0);
  EXPECT_TRUE(std::isinf(reference.uncertainty()));
  EXPECT_EQ(reference.source().substr(0, 6), "nobody");
}

// a spin about the middle axis, of which only the last digits decide how it falls: the closed form
// answers the rounded start, which is nobody's
TEST(ReferenceSolution, KnowsThatRoundingDecidesNearASeparatrix) {
  const Problem p{free_body({1.0, 2.0, 3.0}), {exp_rotation({0.4, 1.1, -0.3}), {1e-15, 24.0, 0.0}}};
  EXPECT_LT(ReferenceSolution(p.model, p.start, 0.3).uncertainty(), 1e-12);
  const ReferenceSolution later(p.model, p.start, 20.0);
  EXPECT_TRUE(std::isinf(later.uncertainty()));
  EXPECT_EQ(later.source().substr(0, 6), "nobody");
}

}  // namespace
}  // namespace polhode::test
