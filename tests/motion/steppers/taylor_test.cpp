// SPDX-License-Identifier: MIT
// The Taylor series of the motion: its last term, and what each of its two views keeps.
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "support/residual.h"
#include "support/stepping.h"
#include "support/taylor_oracle.h"

namespace polhode::test {
namespace {

using Complex = std::complex<double>;

// on a sphere q is a series of exp: cut after order 10 or 16
TEST(Taylor, TurnsASphereByTheSeriesOfExp) {
  for (const auto& [method, order] : {std::pair{"taylor10", 10}, {"taylor16", 16}}) {
    for (const double turn : {1.0, 6.0}) {
      const Complex z(0.0, 0.5 * turn);
      Complex sum = 1.0, term = 1.0;
      for (int k = 1; k <= order; ++k)
        sum += term *= z / static_cast<double>(k);
      const double found = turn_of_sphere(method, turn);
      expect_residual(
          method, std::abs(std::remainder(found - 2.0 * std::arg(sum), 4.0 * M_PI)), 6e-15);
    }
  }
}

TEST(Taylor, ItsEstimateIsItsLastTerm) {
  const Problem p{free_body({2, 2, 2}), {Quat::Identity(), {0.0, 1.2, -1.6}}};
  for (const auto& [method, order] : {std::pair{"taylor10", 10}, {"taylor16", 16}}) {
    State s = p.start;
    Work work;
    const double estimate = stepper(method, p)->step_with_error(0.0, 3.0, s, work);
    const double x = 0.5 * 3.0 * 1.0;  // half of h |omega|
    EXPECT_NEAR(estimate / (std::pow(x, order) / std::tgamma(order + 1)), 1.0, 1e-13) << method;
  }
}

// a symmetric top is seen from space, without its own spin: that stays to the last bit, and a fast
// top costs no accuracy; seen in its own axes the same step is beyond the series
TEST(Taylor, ASpinAboutTheAxisOfSymmetryIsNotExpanded) {
  for (const double spin : {0.5, 500.0}) {
    const Problem p{heavy_body({1, 1, 0.5}, Vec3::UnitZ()),
                    {exp_rotation({0.5, 0, 0}), {0.1, 0.0, 0.01 * spin}}};
    const State s = after("taylor16", p, 0.05, 40);
    EXPECT_EQ(s.y[2], p.start.y[2]);
    expect_residual("taylor16", distance(s, TaylorOracle(p.model, p.start).at(2.0L)), 1e-13);
  }
}

}  // namespace
}  // namespace polhode::test
