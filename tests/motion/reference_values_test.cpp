// SPDX-License-Identifier: MIT
// Published and independently computed end states, to as many digits as a method can give.
#include <cmath>

#include <gtest/gtest.h>

#include "motion/grid_trajectory.h"
#include "motion/stepper_table.h"
#include "support/residual.h"
#include "support/taylor_oracle.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;

const State kHairerVilmartAt10 = {
    Quat(-0.73606136416079393616,
         -0.57078695124035073325,
         -0.29938857183079009374,
         -0.20683908610467319248),
    Vec3(1.7659625085182075357, -0.6954641970330891195, 0.7795549814818710861)};

const State kGniTopAt30 = {
    Quat(-0.43556098558439444, -0.3700636549040742, 0.26480479131047299, -0.77667106399994462),
    Vec3(0.95995717781986385, -0.36416972569944915, 0.4)};

// the judge is judged first: against values of a 34-digit integration
TEST(TaylorOracle, ReproducesThePublishedDigits) {
  TaylorOracle free(
      {0.6L, 0.8L, 1.0L}, {0, 0, 0}, {1.8L, 0.4L, -0.9L}, {1, 0, 0, 0}, Vec3::UnitZ());
  free.at(10.0L);
  const TaylorOracle::Real expected[] = {1.7659625085182075357L,
                                         -0.6954641970330891195L,
                                         0.7795549814818710861L,
                                         -0.73606136416079393616L,
                                         -0.57078695124035073325L,
                                         -0.29938857183079009374L,
                                         -0.20683908610467319248L};
  for (int i = 0; i < 7; ++i) {
    const auto found = free.digits()[i < 3 ? i : i + 3];
    expect_residual("HV at 10, 18 digits", double(std::abs(found - expected[i])), 6e-18);
  }
  // the decimal data stored as doubles are already a little different
  TaylorOracle stored(hairer_vilmart().model, hairer_vilmart().start);
  expect_residual("HV at 10 from doubles", distance(stored.at(10.0L), kHairerVilmartAt10), 4e-15);
  TaylorOracle heavy(gni_heavy_top().model, gni_heavy_top().start);
  expect_residual("GNI top at 30", distance(heavy.at(30.0L), kGniTopAt30), 4e-15);
}

TEST(TaylorOracle, ReturnsToItsStartAndIsIndependentOfItsSteps) {
  const Problem p = heavy_asymmetric();
  TaylorOracle there(p.model, p.start);
  there.at(50.0L);
  TaylorOracle many(p.model, p.start);
  for (int i = 1; i <= 500; ++i)
    many.at(0.1L * i);
  for (int i = 0; i < 10; ++i) {
    EXPECT_NEAR(double(there.digits()[i] - many.digits()[i]), 0.0, 2e-17);
  }
  there.at(0.0L);
  EXPECT_LE(distance(there.state(), p.start), 3e-16);
}

struct Reach {
  const char* method;
  double h;
  double free_error;   // bound of the Hairer-Vilmart end state: measured x 2
  double heavy_error;  // of the GNI top; 0: the method takes no gravity
};

void PrintTo(const Reach& reach, std::ostream* out) {
  *out << reach.method;
}

class EndState : public testing::TestWithParam<Reach> {};

INSTANTIATE_TEST_SUITE_P(Methods,
                         EndState,
                         testing::Values(Reach{"rk4", 1e-3, 4e-12, 1e-11},
                                         Reach{"implicit_midpoint", 1e-3, 6e-5, 7e-5},
                                         Reach{"dopri5", 2e-3, 1e-13, 3e-13},
                                         Reach{"explicit_euler", 1e-4, 3e-3, 3e-2},
                                         Reach{"rk2", 1e-3, 3e-5, 5e-5},
                                         Reach{"dop853", 2e-2, 4e-14, 7e-14},
                                         Reach{"gauss4", 5e-3, 4e-10, 2e-9},
                                         Reach{"gauss6", 1e-2, 1e-14, 2e-13},
                                         Reach{"rkmk4", 1e-3, 2e-12, 4e-12},
                                         Reach{"cf4", 1e-3, 2e-12, 8e-12},
                                         Reach{"three_rotations", 1e-3, 4e-6, 4e-5},
                                         Reach{"symmetric_remainder4", 5e-3, 2e-12, 2e-10},
                                         Reach{"symmetric_remainder6", 1e-2, 2e-13, 8e-13},
                                         Reach{"dmv4", 1e-2, 6e-7, 0},
                                         Reach{"dmv6", 2e-2, 1e-9, 0},
                                         Reach{"dmv8", 4e-2, 2e-11, 0},
                                         Reach{"dmv10", 5e-2, 3e-14, 0},
                                         Reach{"kick_chin4", 1e-2, 3e-13, 2e-9},
                                         Reach{"kick_srkn6", 2e-2, 9e-14, 3e-10},
                                         Reach{"kick_srkn11", 4e-2, 1e-13, 3e-12}),
                         [](const auto& reach) { return reach.param.method; });

TEST_P(EndState, HairerVilmart) {
  const auto [method, h, bound, unused] = GetParam();
  const Problem p = hairer_vilmart();
  const auto found = integrate_fixed(find_stepper(method), p.model, p.start, 10.0, h);
  expect_residual(method, distance(found.trajectory->at(10.0), kHairerVilmartAt10), bound);
}

TEST_P(EndState, GniHeavyTop) {
  const auto [method, h, unused, bound] = GetParam();
  const Problem p = gni_heavy_top();
  if (bound == 0.0) {
    EXPECT_FALSE(find_stepper(method).takes_heavy);
    return;
  }
  const auto found = integrate_fixed(find_stepper(method), p.model, p.start, 30.0, h);
  expect_residual(method, distance(found.trajectory->at(30.0), kGniTopAt30), bound);
}

// Hull and others, DETEST, problem B5: z1' = z2 z3, z2' = -z1 z3, z3' = -.51 z1 z2, z0 = (0, 1, 1)
// is (sn, cn, dn). With y = (s1 z2, s2 z1, s3 z3) these are the equations of any asymmetric body.
TEST(EndStates, DetestB5) {
  const Problem shape = hairer_vilmart();
  const Vec3 inverse = shape.model.inverse_moments;
  const double a = inverse[1] - inverse[2];
  const double b = inverse[0] - inverse[2];
  const double c = inverse[0] - inverse[1];
  const Vec3 scale(std::sqrt(0.51 / (b * c)), std::sqrt(0.51 / (a * c)), std::sqrt(1.0 / (a * b)));
  const State start{Quat::Identity(), {scale[0], 0.0, scale[2]}};
  const Vec3 expected(-0.34211777540007490653, -0.93965707987292039619, 0.74141265961999530078);
  State end = TaylorOracle(shape.model, start).at(20.0L);
  expect_residual("B5 oracle", (end.y.cwiseQuotient(scale) - expected).norm(), 1e-14);
  end =
      integrate_fixed(find_stepper("dopri5"), shape.model, start, 20.0, 2e-3).trajectory->at(20.0);
  expect_residual("B5 dopri5", (end.y.cwiseQuotient(scale) - expected).norm(), 1e-12);
}

}  // namespace
}  // namespace polhode
