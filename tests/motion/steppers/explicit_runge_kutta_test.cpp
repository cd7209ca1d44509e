// SPDX-License-Identifier: MIT
// What theory says exactly of the explicit methods: their stability functions, and the energy that
// each makes or loses (rows of docs/where-methods-fail.md).
#include <algorithm>
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "support/residual.h"
#include "support/stepping.h"

namespace polhode::test {
namespace {

using Complex = std::complex<double>;

// 1 + z + z^2/2 + ... + z^n/n!
Complex exponential_series(Complex z, int n) {
  Complex sum = 1.0, term = 1.0;
  for (int k = 1; k <= n; ++k)
    sum += term *= z / static_cast<double>(k);
  return sum;
}

// Hairer, Wanner, Solving Ordinary Differential Equations II, IV.2: a method with as many stages as
// its order has the series of exp; the six stages of dopri5 add z^6/600
TEST(ExplicitRungeKutta, TurnsASphereByItsStabilityFunction) {
  for (const double turn : {0.1, 0.7, 2.0}) {
    const Complex z(0.0, 0.5 * turn);
    const auto expect_turn = [&](const char* method, Complex wanted) {
      const double found = turn_of_sphere(method, turn);
      expect_residual(method, std::abs(found - 2.0 * std::arg(wanted)), 1e-15);
    };
    expect_turn("explicit_euler", exponential_series(z, 1));
    expect_turn("rk2", exponential_series(z, 2));
    expect_turn("rk4", exponential_series(z, 4));
    expect_turn("dopri5", exponential_series(z, 5) + std::pow(z, 6) / 600.0);
  }
}

TEST(ExplicitRungeKutta, CountsItsStagesAndOneMoreForTheEstimate) {
  const Problem p = hairer_vilmart();
  const auto evaluations = [&](const char* method) {
    State s = p.start;
    Work work;
    stepper(method, p)->step(0.0, 0.1, s, work);
    return work.evaluations;
  };
  EXPECT_EQ(evaluations("explicit_euler"), 1);
  EXPECT_EQ(evaluations("rk2"), 2);
  EXPECT_EQ(evaluations("rk4"), 4);
  EXPECT_EQ(evaluations("dopri5"), 6);
  State with = p.start, without = p.start;
  Work work;
  stepper("dopri5", p)->step_with_error(0.0, 0.1, with, work);
  EXPECT_EQ(work.evaluations, 7);
  stepper("dopri5", p)->step(0.0, 0.1, without);
  EXPECT_TRUE(same_bits(with, without));
}

// the difference of a method of order 5 and one of order 4: of the fifth power of the step
TEST(ExplicitRungeKutta, TheEstimateOfDopri5IsOfOrderFive) {
  const Problem p = hairer_vilmart();
  const auto estimate = [&](double h) {
    State s = p.start;
    Work work;
    return stepper("dopri5", p)->step_with_error(0.0, h, s, work);
  };
  EXPECT_NEAR(std::log2(estimate(0.02) / estimate(0.01)), 5.0, 0.05);
}

// E1: |y'|^2 - |y|^2 = h^2 |w x y|^2 and 2 (E' - E) = h^2 k.I^-1 k, k = w x y: growth at every step
TEST(ExplicitRungeKutta, E1ExplicitEulerGrowsByAnExactAmount) {
  const Problem p = hairer_vilmart();
  const double h = 0.05;
  const std::unique_ptr<Stepper> euler = stepper("explicit_euler", p);
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
TEST(ExplicitRungeKutta, E2ExplicitEulerBlowsUpInFiniteTime) {
  const Problem p = hairer_vilmart();
  const double steps[] = {0.1, 0.05, 0.025, 0.0125};
  const double expected[] = {53.1, 106.05, 209.5, 417.2};
  for (int i = 0; i < 4; ++i) {
    const std::unique_ptr<Stepper> euler = stepper("explicit_euler", p);
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
TEST(ExplicitRungeKutta, R0RungeKutta4LosesWhatTheStabilityFunctionSays) {
  const Problem p{free_body({1, 1, 2}), {Quat::Identity(), {1, 0, 4}}};
  const double steps[] = {0.4, 0.2, 0.1};
  const double expected[] = {0.1868180457, 0.9457730295, 0.9982326739};
  for (int i = 0; i < 3; ++i) {
    const std::unique_ptr<Stepper> rk4 = stepper("rk4", p);
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
TEST(ExplicitRungeKutta, R0bRungeKutta4IsUnstableBeyondTwoRootTwo) {
  const auto transverse = [](double x) {
    return transverse_growth("rk4", x, 500);
  };
  EXPECT_LE(transverse(2.82), 1.0);
  EXPECT_GE(transverse(2.84), 10.0);
}

// R0c: the limit of Dormand and Prince's fifth order is 0.997
TEST(ExplicitRungeKutta, R0cDormandPrince5IsUnstableBeyondOne) {
  const auto transverse = [](double x) {
    return transverse_growth("dopri5", x, 2000);
  };
  EXPECT_LT(transverse(0.9), 1.0);
  EXPECT_GT(transverse(1.1), 1.0);
}

// R0c: Runge's midpoint method has |R|^2 = 1 + x^4 / 4 on the imaginary axis: no stable step
TEST(ExplicitRungeKutta, R0cMidpointHasNoStableStep) {
  const double wanted = std::pow(1.0 + std::pow(0.1, 4) / 4.0, 500.0);
  EXPECT_NEAR(transverse_growth("rk2", 0.1, 1000) / wanted, 1.0, 1e-10);
}

// R0d: RK4 loses energy on the asymmetric body, 32 times less for half the step
TEST(ExplicitRungeKutta, R0dRungeKutta4LosesEnergyAsTheFifthPowerOfTheStep) {
  const Problem p = hairer_vilmart();
  const double period = 6.86261617805812;
  const double expected[] = {-2.532e-7, -7.924e-9, -2.477e-10, -7.740e-12};
  for (int i = 0; i < 4; ++i) {
    const int n = 60 << i;
    const std::unique_ptr<Stepper> rk4 = stepper("rk4", p);
    State s = p.start;
    for (int k = 0; k < 20 * n; ++k)
      rk4->step(0.0, period / n, s);
    const double per_period = (energy(p, s) / energy(p, p.start) - 1.0) / 20.0;
    EXPECT_NEAR(per_period / expected[i], 1.0, 1e-3) << n << " steps a period";
  }
}

// J2: what explicit Euler makes of MuJoCo's box in 5 s; rk4 does not notice
TEST(ExplicitRungeKutta, J2EulerOnTheTumblingBox) {
  const Problem p = mujoco_box();
  EXPECT_NEAR(1.0 + relative_energy(p, after("explicit_euler", p, 0.01, 500)), 1.08689455, 5e-9);
  EXPECT_NEAR(relative_energy(p, after("rk4", p, 0.01, 500)), 0.0, 1e-9);
}

}  // namespace
}  // namespace polhode::test
