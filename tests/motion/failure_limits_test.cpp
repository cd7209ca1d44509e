// SPDX-License-Identifier: MIT
// Where methods fail, continued: limits of steps of the geometric methods, of the engines' steps
// and of a chart; and what does not fail.
#include <cmath>

#include <gtest/gtest.h>

#include "motion/stepper_table.h"
#include "support/expect_error.h"
#include "support/residual.h"
#include "support/taylor_oracle.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;

std::unique_ptr<Stepper> stepper(const char* method, const Problem& p) {
  return find_stepper(method).make(p.model, p.start.y.norm());
}

State after(const char* method, const Problem& p, double h, long n) {
  const std::unique_ptr<Stepper> by = stepper(method, p);
  State s = p.start;
  for (long i = 0; i < n; ++i)
    by->step(static_cast<double>(i) * h, h, s);
  return s;
}

double relative_energy(const Problem& p, const State& s) {
  return energy(p.model, s) / energy(p.model, p.start) - 1.0;
}

// I = (1, 1, 2) turns its transverse momentum at Omega = 2, with 1 + z, z = i h Omega in Euler's
// method, times at the transverse momentum of 1e-6 to start with
double transverse_growth(const char* method, double turn, int n) {
  const Problem p{free_body({1, 1, 2}), {Quat::Identity(), {1e-6, 0, 4}}};
  return after(method, p, 0.5 * turn, n).y.head<2>().norm() / 1e-6;
}

// R0c: the stability functions on the imaginary axis
TEST(FailureLimits, R0cRungeKuttaMethods) {
  // |R|^2 = 1 + x^4 / 4
  const double wanted = std::pow(1.0 + std::pow(0.1, 4) / 4.0, 500.0);
  EXPECT_NEAR(transverse_growth("rk2", 0.1, 1000) / wanted, 1.0, 1e-10);
  EXPECT_LT(transverse_growth("dop853", 5.0, 1000), 1.0);
  EXPECT_FALSE(transverse_growth("dop853", 6.5, 1000) < 10.0);  // it ends beyond all numbers
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
TEST(FailureLimits, S1ThreeRotationsHaveAResonance) {
  EXPECT_LT(growth_about_third("three_rotations", 1.93), 100.0);
  EXPECT_GT(growth_about_third("three_rotations", 1.94), 1e4);
}

TEST(FailureLimits, S2SymmetricRemainderHasAResonance) {
  EXPECT_LT(growth_about_third("symmetric_remainder2", 2.18), 100.0);
  EXPECT_GT(growth_about_third("symmetric_remainder2", 2.20), 1e4);
}

// S3: on a symmetric body the remainder is nothing, and a step of any length is exact
TEST(FailureLimits, S3SymmetricRemainderIsExactOnSymmetricBodies) {
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
TEST(FailureLimits, ThreeRotationsAreExactAboutAPrincipalAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    const Problem p{free_body({1, 2, 3}), {exp_rotation({0.2, 0.5, 0.1}), 2.0 * Vec3::Unit(axis)}};
    const State exact = TaylorOracle(p.model, p.start).at(7.0L);
    expect_residual("one axis", distance(after("three_rotations", p, 7.0, 1), exact), 5e-14);
  }
}

// the exact free flow inside the kick methods, on asymmetric bodies too, and far
TEST(FailureLimits, KickMethodsAreExactWithoutGravity) {
  const Vec3 starts[] = {
      {1.8, 0.4, -0.9}, {0, 0, 2}, {0, 1e-7, -2}, {1e-3, 2, 1e-3}, {-3, 0, 1e-9}};
  for (const Vec3& y : starts) {
    const Problem p{free_body({0.6, 0.8, 1.0}), {exp_rotation({0.2, 0.5, 0.1}), y}};
    for (const double t : {0.01, 1.0, -8.0}) {
      const State exact = TaylorOracle(p.model, p.start).at(t);
      expect_residual("free flow", distance(after("kick_strang", p, t, 1), exact), 2e-14);
    }
  }
}

// D1: about a principal axis a step turns by asin(h omega), and there is none beyond 1
TEST(FailureLimits, D1DiscreteMoserVeselovTurnsByAnArcsine) {
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
TEST(FailureLimits, D2AFlatBodyNeedsShortSteps) {
  const Problem p{free_body({0.345, 0.653, 1.0}), {Quat::Identity(), {1.8, 0.4, -0.9}}};
  expect_error([&] { after("dmv2", p, 0.2, 50); }, Fault::check_failed, "", "dmv2 found no");
  expect_residual("D2", std::abs(relative_energy(p, after("dmv2", p, 0.1, 100))), 4e-15);
}

// J1: 2 (E' - E) = -|L|^4 det(J - J_L) h^2 / (1 + h^2 k^2 / L^2), J = I^-1, J_L = 2 E / L^2,
// k = y x w: the energy goes to that of the middle axis
TEST(FailureLimits, J1RenormalisedStepTumblesAStableSpin) {
  Problem p{free_body({1, 2, 3}), {Quat::Identity(), {0.03, 0.03, 3.0}}};
  const std::unique_ptr<Stepper> by = stepper("renormalised_explicit", p);
  const double h = 1.0 / 60.0;
  const double L2 = p.start.y.squaredNorm();
  State s = p.start;
  double worst = 0.0;
  for (int i = 0; i < 60 * 900; ++i) {
    const double before = 2.0 * energy(p.model, s);
    const double J_L = before / s.y.squaredNorm();
    const double det = (p.model.inverse_moments.array() - J_L).prod();
    const double k2 = s.y.cross(angular_velocity(p.model, s.y)).squaredNorm();
    by->step(0.0, h, s);
    const double wanted = -L2 * L2 * det * h * h / (1.0 + h * h * k2 / L2);
    worst = worse(worst, std::abs(2.0 * energy(p.model, s) - before - wanted));
  }
  expect_residual("J1 identity", worst, 1e-14);
  EXPECT_NEAR(2.0 * energy(p.model, s) / L2, 0.5, 0.01);  // 1 / I2, from 1 / I3
  expect_residual("J1 |L|", std::abs(s.y.norm() / p.start.y.norm() - 1.0), 3e-13);
}

// J2: MuJoCo's box again, with the engines' steps
TEST(FailureLimits, J2EnginesOnTheTumblingBox) {
  const Vec3 moments = Vec3(0.13, 0.10, 0.05) / 3.0;
  const Problem p{free_body(moments), {Quat::Identity(), moments.cwiseProduct(Vec3(1, 2, 3))}};
  const auto ratio = [&](const char* method) {
    return 1.0 + relative_energy(p, after(method, p, 0.01, 500));
  };
  EXPECT_NEAR(ratio("semi_implicit_euler"), 1.08689455, 1e-8);
  EXPECT_NEAR(ratio("linearly_implicit_euler"), 0.92600827, 1e-8);
}

// L2: a chart fails where its angles do, and says so; quaternions do not notice
TEST(FailureLimits, L2EulerAnglesFailUpright) {
  const Problem p{free_body({1, 1, 1}), {exp_rotation({0.5, 0, 0}), {-1, 0, 0}}};
  const State exact = TaylorOracle(p.model, p.start).at(1.0L);
  expect_residual("L2 quaternions", distance(after("rk4", p, 0.01, 100), exact), 1e-11);
  const Problem near{p.model, {p.start.q, {-1, 1e-3, 0}}};
  expect_error([&] { after("rk4_euler_angles", near, 0.01, 100); },
               Fault::check_failed,
               "",
               "have no rates");
}

// L3: a fast top, with the step too long for its spin by RK4, is no trouble for kicks
TEST(FailureLimits, L3SpinLimitsRungeKuttaNotKicks) {
  const Problem p{heavy_body({1, 1, 0.5}, 0.5 * Vec3::UnitZ()),
                  {exp_rotation({0.5, 0, 0}), {0.1, 0.0, 50.0}}};
  const double turn = 100.0 * (1.0 / 0.5 - 1.0) * 0.5;  // of the momentum in the body, rad/s
  const double h = 3.0 / turn;
  const State exact = TaylorOracle(p.model, p.start).at(200.0L * h);
  EXPECT_FALSE(distance(after("rk4", p, h, 200), exact) < 0.5);
  expect_residual("L3 kicks", distance(after("kick_srkn11", p, h, 200), exact), 6e-9);
}

// L5: kicks keep L.up to round-off and energy within a bound, for as long as one looks; RK4 loses
TEST(FailureLimits, L5KicksDoNotDrift) {
  const Problem p = gni_heavy_top();
  const auto worst_energy = [&](const char* method, State& s, int n) {
    const std::unique_ptr<Stepper> by = stepper(method, p);
    double worst = 0.0;
    for (int i = 0; i < n; ++i) {
      by->step(0.0, 0.1, s);
      worst = worse(worst, std::abs(energy(p.model, s) - energy(p.model, p.start)));
    }
    return worst;
  };
  for (const char* method : {"kick_strang", "kick_suzuki4", "kick_chin4", "kick_srkn6"}) {
    State s = p.start;
    const double early = worst_energy(method, s, 1000);
    const double late = worst_energy(method, s, 100'000);
    EXPECT_LT(late, 1.5 * early) << method;
    const double up = momentum_in_space(s)[2] - momentum_in_space(p.start)[2];
    expect_residual(std::string("L5 L.up ") + method, std::abs(up), 3e-13);
  }
  State s = p.start;
  const double early = worst_energy("rk4", s, 1000);
  EXPECT_GT(worst_energy("rk4", s, 9000), 5.0 * early);
}

}  // namespace
}  // namespace polhode
