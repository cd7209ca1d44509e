// SPDX-License-Identifier: MIT
// The discrete Moser-Veselov algorithm: its arcsine, its limit, and the orders of its variants.
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/residual.h"
#include "support/stepping.h"
#include "support/taylor_oracle.h"

namespace polhode::test {
namespace {

// D1: about a principal axis a step turns by asin(h omega), and there is none beyond 1
TEST(DiscreteMoserVeselov, D1TurnsByAnArcsine) {
  const Problem p{free_body({1, 2, 3}), {Quat::Identity(), {0, 0, 3}}};
  for (const double turn : {0.1, 0.5, 0.9, 0.999}) {
    const double found = rotation_angle_between(after("dmv2", p, turn, 1).q, p.start.q);
    expect_residual("D1", std::abs(found - std::asin(turn)), 1e-15);
  }
  for (const double turn : {1.001, 1.5, 10.0}) {
    expect_error([&] { after("dmv2", p, turn, 1); }, Fault::check_failed, "", "h |omega| = 1");
  }
}

// D2: the flat body of Hairer and Vilmart with 50 steps to t = 10 is beyond, with 100 it is not
TEST(DiscreteMoserVeselov, D2AFlatBodyNeedsShortSteps) {
  const Problem p{free_body({0.345, 0.653, 1.0}), {Quat::Identity(), {1.8, 0.4, -0.9}}};
  expect_error([&] { after("dmv2", p, 0.2, 50); }, Fault::check_failed, "", "dmv2 found no");
  expect_residual("D2", std::abs(relative_energy(p, after("dmv2", p, 0.1, 100))), 4e-15);
}

// D3: discrete Moser-Veselov on both bodies of Hairer and Vilmart: order and invariants
TEST(DiscreteMoserVeselov, D3HasItsOrderAndInvariantsOnBothBodies) {
  const Problem bodies[] = {hairer_vilmart(),
                            {free_body({0.345, 0.653, 1.0}), {Quat::Identity(), {1.8, 0.4, -0.9}}}};
  for (const Problem& p : bodies) {
    const State truth = TaylorOracle(p.model, p.start).at(4.0L);
    for (const auto& [method, order, n] : {std::tuple{"dmv2", 2, 400L},
                                           {"dmv4", 4, 200L},
                                           {"dmv6", 6, 120L},
                                           {"dmv8", 8, 80L},
                                           {"dmv10", 10, 60L}}) {
      const double h = 4.0 / static_cast<double>(n);
      const double coarse = distance(after(method, p, h, n), truth);
      const double fine = distance(after(method, p, h / 1.5, n * 3 / 2), truth);
      EXPECT_NEAR(std::log(coarse / fine) / std::log(1.5), order, 0.06 * order + 0.1) << method;
      const State end = after(method, p, h, 4 * n);
      expect_residual(
          "D3 energy", std::abs(energy(p.model, end) / energy(p.model, p.start) - 1.0), 1e-13);
      expect_residual("D3 L", (momentum_in_space(end) - momentum_in_space(p.start)).norm(), 1e-13);
    }
  }
}

// about a principal axis the modified moments must undo the arcsine up to the order
TEST(DiscreteMoserVeselov, PreprocessingUndoesTheArcsine) {
  const Problem p{free_body({1, 2, 3}), {Quat::Identity(), {0, 0, 3}}};
  for (const auto& [method, order] :
       {std::pair{"dmv2", 2}, {"dmv4", 4}, {"dmv6", 6}, {"dmv8", 8}, {"dmv10", 10}}) {
    const auto error = [&, name = method](double turn) {
      return std::abs(rotation_angle_between(after(name, p, turn, 1).q, p.start.q) - turn);
    };
    EXPECT_NEAR(std::log2(error(0.4) / error(0.2)), order + 1, 0.4) << method;
  }
}

}  // namespace
}  // namespace polhode::test
