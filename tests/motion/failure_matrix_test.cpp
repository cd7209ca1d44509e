// SPDX-License-Identifier: MIT
// Where methods fail: rows of the stability matrix that theory predicts exactly.
#include <cmath>

#include <gtest/gtest.h>

#include "motion/stepper_table.h"
#include "support/expect_error.h"
#include "support/residual.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;

double energy(const Problem& p, const State& s) {
  return energy(p.model, s);
}

// E1: |y'|^2 - |y|^2 = h^2 |w x y|^2 and 2 (E' - E) = h^2 k.I^-1 k, k = w x y: growth at every step
TEST(FailureMatrix, E1ExplicitEulerGrowsByAnExactAmount) {
  const Problem p = hairer_vilmart();
  const double h = 0.05;
  const std::unique_ptr<Stepper> euler = find_stepper("explicit_euler").make(p.model, 1.0);
  State s = p.start;
  double worst_norm = 0.0, worst_energy = 0.0, least_growth = 1.0;
  for (int i = 0; i < 200; ++i) {
    State next = s;
    euler->step(i * h, h, next);
    const Vec3 k = angular_velocity(p.model, s.y).cross(s.y);
    const double norm_growth = next.y.squaredNorm() - s.y.squaredNorm();
    const double energy_growth = 2.0 * (energy(p, next) - energy(p, s));
    const double size = s.y.squaredNorm();
    worst_norm = worse(worst_norm, std::abs(norm_growth - h * h * k.squaredNorm()) / size);
    worst_energy = worse(
        worst_energy, std::abs(energy_growth - h * h * k.dot(angular_velocity(p.model, k))) / size);
    least_growth = std::min(least_growth, norm_growth / size);
    s = next;
  }
  expect_residual("E1 |y|^2 growth", worst_norm, 2e-15);
  expect_residual("E1 energy growth", worst_energy, 4e-15);
  expect_effect("E1 grows at every step", least_growth, 1e-6);
}

// E2: the blow-up time is inversely proportional to the step
TEST(FailureMatrix, E2ExplicitEulerBlowsUpInFiniteTime) {
  const Problem p = hairer_vilmart();
  const double steps[] = {0.1, 0.05, 0.025, 0.0125};
  const double expected[] = {53.1, 106.05, 209.5, 417.2};
  for (int i = 0; i < 4; ++i) {
    const std::unique_ptr<Stepper> euler = find_stepper("explicit_euler").make(p.model, 1.0);
    State s = p.start;
    long n = 0;
    while (s.y.norm() < 1e6 && n < 100'000)
      euler->step(0.0, steps[i], s), ++n;
    // when exactly the numbers run away depends on the threshold by some steps
    EXPECT_NEAR(n * steps[i], expected[i], 0.02 * expected[i]);
  }
}

// R0: RK4 damps the transverse momentum of I = (1, 1, 2) by 1 - x^6/72 + x^8/576 a step, x = h
// Omega
TEST(FailureMatrix, R0RungeKutta4LosesWhatTheStabilityFunctionSays) {
  const Problem p{free_body({1, 1, 2}), {Quat::Identity(), {1, 0, 4}}};
  const double steps[] = {0.4, 0.2, 0.1};
  const double expected[] = {0.1868180457, 0.9457730295, 0.9982326739};
  for (int i = 0; i < 3; ++i) {
    const std::unique_ptr<Stepper> rk4 = find_stepper("rk4").make(p.model, 1.0);
    const int n = static_cast<int>(std::lround(200.0 / steps[i]));
    State s = p.start;
    for (int k = 0; k < n; ++k)
      rk4->step(0.0, steps[i], s);
    const double transverse = s.y.head<2>().squaredNorm();
    const double x = 2.0 * steps[i];
    const double factor = std::pow(1.0 - std::pow(x, 6) / 72 + std::pow(x, 8) / 576, n);
    expect_residual("R0 ten digits", std::abs(transverse - expected[i]), 6e-11);
    expect_residual("R0 stability function", std::abs(transverse - factor), 1e-12);
  }
}

// R0b: the limit of RK4 on the imaginary axis is 2 sqrt 2
TEST(FailureMatrix, R0bRungeKutta4IsUnstableBeyondTwoRootTwo) {
  const Problem p{free_body({1, 1, 2}), {Quat::Identity(), {1e-6, 0, 4}}};
  const auto transverse = [&](double x) {
    const std::unique_ptr<Stepper> rk4 = find_stepper("rk4").make(p.model, 1.0);
    State s = p.start;
    for (int k = 0; k < 500; ++k)
      rk4->step(0.0, 0.5 * x, s);
    return s.y.head<2>().norm() / 1e-6;
  };
  EXPECT_LE(transverse(2.82), 1.0);
  EXPECT_GE(transverse(2.84), 10.0);
}

// R0c: the limit of Dormand and Prince's fifth order is 0.997
TEST(FailureMatrix, R0cDormandPrince5IsUnstableBeyondOne) {
  const Problem p{free_body({1, 1, 2}), {Quat::Identity(), {1e-6, 0, 4}}};
  const auto transverse = [&](double x) {
    const std::unique_ptr<Stepper> dopri5 = find_stepper("dopri5").make(p.model, 1.0);
    State s = p.start;
    for (int k = 0; k < 2000; ++k)
      dopri5->step(0.0, 0.5 * x, s);
    return s.y.head<2>().norm() / 1e-6;
  };
  EXPECT_LT(transverse(0.9), 1.0);
  EXPECT_GT(transverse(1.1), 1.0);
}

// R0d: RK4 loses energy on the asymmetric body, 32 times less for half the step
TEST(FailureMatrix, R0dRungeKutta4LosesEnergyAsTheFifthPowerOfTheStep) {
  const Problem p = hairer_vilmart();
  const double period = 6.86261617805812;
  const double expected[] = {-2.532e-7, -7.924e-9, -2.477e-10, -7.740e-12};
  for (int i = 0; i < 4; ++i) {
    const int n = 60 << i;
    const std::unique_ptr<Stepper> rk4 = find_stepper("rk4").make(p.model, 1.0);
    State s = p.start;
    for (int k = 0; k < 20 * n; ++k)
      rk4->step(0.0, period / n, s);
    const double per_period = (energy(p, s) / energy(p, p.start) - 1.0) / 20.0;
    EXPECT_NEAR(per_period / expected[i], 1.0, 1e-3) << n << " steps a period";
  }
}

// M1: whenever Newton converges, energy and |L| are kept to round-off, however large the step
TEST(FailureMatrix, M1ImplicitMidpointKeepsEnergyAtEveryStep) {
  const Problem p = hairer_vilmart();
  const double rate = angular_velocity(p.model, p.start.y).norm();
  for (const double turn : {0.16, 0.5, 1.6, 5.0, 16.0}) {
    const std::unique_ptr<Stepper> midpoint = find_stepper("implicit_midpoint").make(p.model, 1.0);
    State s = p.start;
    int solved = 0;
    double drift = 0.0;
    try {
      for (; solved < 200; ++solved) {
        midpoint->step(0.0, turn / rate, s);
        drift = worse(drift, std::abs(energy(p, s) / energy(p, p.start) - 1.0));
        drift = worse(drift, std::abs(s.y.norm() / p.start.y.norm() - 1.0));
      }
    } catch (const Error& error) {
      // a step without solution must be reported, and only where steps are absurdly long
      EXPECT_EQ(error.fault(), Fault::check_failed);
      EXPECT_GE(turn, 5.0) << error.what();
    }
    expect_residual(fmt::format("M1 h|w| = {}, {} steps", turn, solved), drift, 3e-14);
  }
}

// M2: Newton's method solves the midpoint rule beyond the limit of fixed-point iteration (h = 2
// here)
TEST(FailureMatrix, M2ImplicitMidpointPassesTheFixedPointLimit) {
  const Problem p{free_body({1, 2, 3}), {Quat::Identity(), {1e-3, 1e-3, 3.0}}};
  const std::unique_ptr<Stepper> midpoint = find_stepper("implicit_midpoint").make(p.model, 1.0);
  State s = p.start;
  for (int i = 0; i < 100; ++i)
    midpoint->step(0.0, 2.02, s);
  EXPECT_NEAR(energy(p, s) / energy(p, p.start), 1.0, 1e-14);
}

// J2: the tumbling box of MuJoCo's tests, half-sizes .1 .2 .3 m, 1 kg
TEST(FailureMatrix, J2TheBoxOfMujoco) {
  BodySpec spec;
  spec.solid.emplace();
  spec.solid->kind = "box";
  spec.solid->mass = 1.0;
  spec.solid->size = Vec3(0.2, 0.4, 0.6);
  Problem p{make_model(spec, false, Vec3::Zero()), {}};
  p.start.y = p.model.moments.cwiseProduct(Vec3(1, 2, 3));
  const auto energy_ratio = [&](const char* method) {
    const std::unique_ptr<Stepper> stepper = find_stepper(method).make(p.model, 1.0);
    State s = p.start;
    for (int i = 0; i < 500; ++i)
      stepper->step(0.0, 0.01, s);
    return energy(p, s) / energy(p, p.start);
  };
  EXPECT_NEAR(energy_ratio("explicit_euler"), 1.08689455, 5e-9);
  EXPECT_NEAR(energy_ratio("rk4"), 1.0, 1e-9);
  EXPECT_NEAR(energy_ratio("implicit_midpoint"), 1.0, 1e-14);
}

// L4: a sleeping top falls over below w* = 2 sqrt(A mu) / C, at the rate sqrt(4 A mu - C^2 w^2) /
// 2A
TEST(FailureMatrix, L4SleepingTop) {
  const BodyModel model = heavy_body({1, 1, 0.5}, {0, 0, 1});
  const double critical = 4.0;
  const auto tilt_after = [&](double ratio, double t) {
    const double h = 0.005;
    const Problem p{model, {exp_rotation({1e-9, 0, 0}), {0, 0, 0.5 * ratio * critical}}};
    const std::unique_ptr<Stepper> rk4 = find_stepper("rk4").make(p.model, 1.0);
    State s = p.start;
    for (int i = 0; i < std::lround(t / h); ++i)
      rk4->step(0.0, h, s);
    return zxz_angles(s.q)[1];
  };
  EXPECT_LE(tilt_after(1.05, 30.0), 1e-8);
  for (const double ratio : {0.95, 0.5}) {
    const double rate = std::sqrt(4.0 - std::pow(2.0 * ratio, 2)) / 2.0;
    const double from = 8.0 / rate;
    const double measured = std::log(tilt_after(ratio, 1.5 * from) / tilt_after(ratio, from)) /
                            (std::lround(1.5 * from / 0.005) - std::lround(from / 0.005)) / 0.005;
    EXPECT_NEAR(measured, rate, 2e-3) << "at " << ratio << " of the critical spin";
  }
}

}  // namespace
}  // namespace polhode
