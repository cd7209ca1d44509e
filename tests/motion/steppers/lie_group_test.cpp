// SPDX-License-Identifier: MIT
// Runge-Kutta methods on the group: exact about a fixed axis, and true to L in space.
#include <cmath>

#include <gtest/gtest.h>

#include "support/residual.h"
#include "support/stepping.h"
#include "support/taylor_oracle.h"

namespace polhode::test {
namespace {

// about a principal axis the rates commute, and a step is one exponential: exact at any length
TEST(LieGroup, IsExactAboutAPrincipalAxis) {
  for (const char* method : {"rkmk4", "cf4"}) {
    for (int axis = 0; axis < 3; ++axis) {
      const Problem p{free_body({1, 2, 3}),
                      {exp_rotation({0.2, 0.5, 0.1}), 2.0 * Vec3::Unit(axis)}};
      const State exact = TaylorOracle(p.model, p.start).at(1.4L);
      expect_residual(method, distance(after(method, p, 1.4, 1), exact), 2e-15);
    }
  }
}

// y is never integrated: it is L turned into the body, so that long steps lose phase and no
// momentum
TEST(LieGroup, KeepsMomentumInSpaceAtAbsurdSteps) {
  const Problem p = hairer_vilmart();
  for (const char* method : {"rkmk4", "cf4"}) {
    const State s = after(method, p, 1.5, 100);
    expect_residual(method, (momentum_in_space(s) - momentum_in_space(p.start)).norm(), 3e-14);
    expect_effect(method, std::abs(relative_energy(p, s)), 1e-3);
  }
}

TEST(LieGroup, KeepsTheVerticalMomentumUnderGravity) {
  const Problem p = heavy_asymmetric();
  for (const char* method : {"rkmk4", "cf4"}) {
    const Vec3 change = momentum_in_space(after(method, p, 0.3, 200)) - momentum_in_space(p.start);
    expect_residual(method, std::abs(change.dot(p.model.up_S)), 1e-13);
    expect_effect(method, change.norm(), 1e-3);
  }
}

}  // namespace
}  // namespace polhode::test
