// SPDX-License-Identifier: MIT
// The classical method on zxz angles: exact where they run uniformly, refused where they fail.
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "support/expect_error.h"
#include "support/residual.h"
#include "support/stepping.h"
#include "support/taylor_oracle.h"

namespace polhode::test {
namespace {

// a sphere that turns about the vertical: phi runs, theta and psi rest, and a step of any length
// below half a turn is exact
TEST(EulerAngles, AreExactAboutTheVertical) {
  const Quat q = from_zxz_angles({0.3, 1.1, -0.4});
  const Problem p{free_body({1, 1, 1}), {q, 2.0 * (q.conjugate() * Vec3::UnitZ())}};
  for (const double turn : {0.5, 2.0, 3.0}) {
    const State s = after("rk4_euler_angles", p, 0.5 * turn, 1);
    const State exact{exp_rotation(turn * Vec3::UnitZ()) * q, p.start.y};
    expect_residual("about the vertical", distance(s, exact), 4e-15);
  }
}

// phi has no rate beyond half a turn in a step: its winding would be lost
TEST(EulerAngles, RefuseMoreThanHalfATurnInAStep) {
  const Quat q = from_zxz_angles({0.3, 1.1, -0.4});
  const Problem p{free_body({1, 1, 1}), {q, q.conjugate() * Vec3::UnitZ()}};
  EXPECT_NO_THROW(after("rk4_euler_angles", p, 0.99 * kPi, 1));
  expect_error([&] { after("rk4_euler_angles", p, 1.01 * kPi, 1); },
               Fault::check_failed,
               "",
               "rk4_euler_angles found no solution of its step at t = 0 s");
}

// L2: a chart fails where its angles do, and says so; quaternions do not notice
TEST(EulerAngles, L2EulerAnglesFailUpright) {
  const Problem p{free_body({1, 1, 1}), {exp_rotation({0.5, 0, 0}), {-1, 0, 0}}};
  const State exact = TaylorOracle(p.model, p.start).at(1.0L);
  expect_residual("L2 quaternions", distance(after("rk4", p, 0.01, 100), exact), 1e-11);
  const Problem near{p.model, {p.start.q, {-1, 1e-3, 0}}};
  expect_error([&] { after("rk4_euler_angles", near, 0.01, 100); },
               Fault::check_failed,
               "",
               "have no rates");
}

}  // namespace
}  // namespace polhode::test
