// SPDX-License-Identifier: MIT
// The collocation methods of Gauss: their stability functions and the limit of their iteration.
#include <cmath>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/residual.h"
#include "support/stepping.h"

namespace polhode::test {
namespace {

// the diagonal Pade approximants of exp (Hairer, Wanner, Solving Ordinary Differential Equations
// II, IV.3): of modulus one on the imaginary axis, so that the angle is all there is
TEST(Gauss, TurnsASphereByThePadeApproximants) {
  for (const double turn : {0.1, 0.5, 1.0}) {
    const double x = 0.5 * turn;
    const double by4 = 4.0 * std::atan2(x / 2.0, 1.0 - x * x / 12.0);
    const double by6 = 4.0 * std::atan2(x / 2.0 - x * x * x / 120.0, 1.0 - x * x / 10.0);
    expect_residual("gauss4", std::abs(turn_of_sphere("gauss4", turn) - by4), 1e-15);
    expect_residual("gauss6", std::abs(turn_of_sphere("gauss6", turn) - by6), 1e-15);
  }
}

// gravity included: energy is quadratic in (q, y) here; L in space is of third degree, and is not
TEST(Gauss, KeepsEnergyUnderGravityAndLosesMomentumInSpace) {
  const Problem heavy = heavy_asymmetric();
  const Problem free = hairer_vilmart();
  for (const char* method : {"gauss4", "gauss6"}) {
    const State s = after(method, heavy, 0.2, 200);
    expect_residual(method, std::abs(energy(heavy, s) - energy(heavy, heavy.start)), 3e-14);
    const State t = after(method, free, 0.2, 200);
    expect_residual(method, std::abs(t.y.norm() - free.start.y.norm()), 1e-14);
    expect_effect(method, (momentum_in_space(t) - momentum_in_space(free.start)).norm(), 1e-9);
  }
}

TEST(Gauss, AStepWithoutSolutionIsAnErrorThatSaysSo) {
  const Problem p = hairer_vilmart();
  for (const char* method : {"gauss4", "gauss6"}) {
    expect_error([&] { after(method, p, 20.0, 1); },
                 Fault::check_failed,
                 "",
                 std::string(method) + " found no solution of its step at t = 0 s with step 20 s");
  }
}

}  // namespace
}  // namespace polhode::test
