// SPDX-License-Identifier: MIT
#include "motion/steppers/splitting.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/residual.h"
#include "support/stepping.h"
#include "support/taylor_oracle.h"

namespace polhode::test {
namespace {

// a free body that never moves, and writes down how long it was asked to
struct Still {
  static inline std::vector<double> times;

  explicit Still(const BodyModel&) {}
  void operator()(double h, const Quat&, const Vec3&) const { times.push_back(h); }
};

// kicks alone, at a fixed attitude: the momentum changes by h times the torque
TEST(Splitting, KicksAndFlowsAddUpToTheStep) {
  constexpr SplittingScheme kScheme = composition<3>({0.7, -0.4, 0.7});
  const Problem p = heavy_asymmetric();
  Still::times.clear();
  State s = p.start;
  Work work;
  Splitting<Still>(p.model, kScheme).step(0.0, 0.3, s, work);
  const Vec3 torque = up_in_body(p.model, p.start.q).cross(p.model.chi_P);
  EXPECT_LE((s.y - p.start.y - 0.3 * torque).norm(), 1e-15);
  ASSERT_EQ(Still::times.size(), 3U);
  EXPECT_DOUBLE_EQ(Still::times[0], 0.3 * 0.7);
  EXPECT_DOUBLE_EQ(Still::times[1], 0.3 * -0.4);
  EXPECT_DOUBLE_EQ(Still::times[2], 0.3 * 0.7);
  EXPECT_EQ(work.evaluations, 4);
}

TEST(Splitting, ACompositionIsSymmetricWithHalfKicksAtItsEnds) {
  constexpr SplittingScheme kScheme = composition<3>({0.7, -0.4, 0.7});
  EXPECT_EQ(kScheme.flows, 3U);
  EXPECT_DOUBLE_EQ(kScheme.b[0], 0.35);
  EXPECT_DOUBLE_EQ(kScheme.b[1], 0.15);
  for (std::size_t i = 0; i <= kScheme.flows; ++i)
    EXPECT_DOUBLE_EQ(kScheme.b[i], kScheme.b[kScheme.flows - i]);
}

// their fractions add up to one: on a sphere every scheme is one turn about L
TEST(Splitting, EverySchemeOfTheTableAddsUpToTheStep) {
  for (const char* method : {"symmetric_remainder2",
                             "symmetric_remainder4",
                             "symmetric_remainder6",
                             "kick_strang",
                             "kick_suzuki4",
                             "kick_chin4",
                             "kick_srkn6",
                             "kick_srkn11"})
    expect_residual(method, std::abs(turn_of_sphere(method, 2.0) - 2.0), 3e-14);
}

// how much a small deviation from spin about the third axis of I = (1, 2, 3) grows in 500 steps
double growth_about_third(const char* method, double turn) {
  const Problem p{free_body({1, 2, 3}), {Quat::Identity(), {1e-9, 1e-9, 3.0}}};
  const std::unique_ptr<Stepper> by = stepper(method, p);
  State s = p.start;
  double most = 0.0;
  for (int i = 0; i < 500; ++i) {
    by->step(0.0, turn, s);
    most = worse(most, s.y.head<2>().norm() / p.start.y.head<2>().norm());
  }
  return most;
}

// S1, S2: resonances of the splittings, from the trace of the linear map of a step
TEST(Splitting, S1ThreeRotationsHaveAResonance) {
  EXPECT_LT(growth_about_third("three_rotations", 1.93), 100.0);
  EXPECT_GT(growth_about_third("three_rotations", 1.94), 1e4);
}

TEST(Splitting, S2SymmetricRemainderHasAResonance) {
  EXPECT_LT(growth_about_third("symmetric_remainder2", 2.18), 100.0);
  EXPECT_GT(growth_about_third("symmetric_remainder2", 2.20), 1e4);
}

// S3: on a symmetric body the remainder is nothing, and a step of any length is exact
TEST(Splitting, S3SymmetricRemainderIsExactOnSymmetricBodies) {
  for (const Vec3& moments : {Vec3(1, 1, 1.8), Vec3(0.4, 1, 1), Vec3(1, 0.3, 1), Vec3(1, 1, 1)}) {
    const Problem p{free_body(moments), {exp_rotation({0.2, 0.5, 0.1}), {0.8, -0.3, 1.1}}};
    const State exact = TaylorOracle(p.model, p.start).at(50.0L);
    for (const char* method : {"symmetric_remainder2", "symmetric_remainder4", "kick_strang"}) {
      expect_residual("S3 one step", distance(after(method, p, 50.0, 1), exact), 5e-14);
      expect_residual("S3 many steps", distance(after(method, p, 0.05, 1000), exact), 2e-13);
    }
  }
}

// three rotations are exact for spin about a principal axis
TEST(Splitting, ThreeRotationsAreExactAboutAPrincipalAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    const Problem p{free_body({1, 2, 3}), {exp_rotation({0.2, 0.5, 0.1}), 2.0 * Vec3::Unit(axis)}};
    const State exact = TaylorOracle(p.model, p.start).at(7.0L);
    expect_residual("one axis", distance(after("three_rotations", p, 7.0, 1), exact), 5e-14);
  }
}

}  // namespace
}  // namespace polhode::test
