// SPDX-License-Identifier: MIT
// Failures that more than one method shows, or none by itself (docs/where-methods-fail.md): what
// the usual invariants do not see, what round-off does over a million steps, constants of
// integrable tops, fast tops, and chaos. Those of single methods are in steppers/.
#include <cmath>

#include <gtest/gtest.h>

#include "motion/exact/exact.h"
#include "motion/scales.h"
#include "motion/stepper_table.h"
#include "motion/walk.h"
#include "support/residual.h"
#include "support/stepping.h"
#include "support/taylor_oracle.h"

namespace polhode::test {
namespace {

State walked(const char* method, const Problem& p, double h, long n) {
  const StepperInfo& row = find_stepper(method);
  const std::unique_ptr<Stepper> stepper = row.make(p.model, momentum_scale(p.model, p.start));
  State s = p.start;
  walk_fixed(*stepper, s, h, n, kLookAway);
  return s;
}

State adapted(const char* method, const Problem& p, double duration, double tolerance) {
  const StepperInfo& row = find_stepper(method);
  const std::unique_ptr<Stepper> stepper = row.make(p.model, momentum_scale(p.model, p.start));
  State s = p.start;
  walk_adaptive(row, *stepper, s, duration, tolerance, 0.01, {}, kLookAway);
  return s;
}

// G1: the momentum of the body held still in the body (no gyroscopic term) keeps energy and |L|
// perfectly, and is wrong: only L in space shows it
TEST(WhereMethodsFail, G1MissingGyroscopicTermIsSeenInSpaceOnly) {
  const Problem p{free_body({1, 2, 3}), {Quat::Identity(), {1.0, 1.0, 1.0}}};
  const Vec3 w = angular_velocity(p.model, p.start.y);
  State frozen = p.start;
  double turned = 0.0;
  for (int i = 1; i <= 1000; ++i) {
    frozen.q = p.start.q * exp_rotation(0.01 * i * w);
    const Vec3 L = momentum_in_space(frozen), L0 = momentum_in_space(p.start);
    turned =
        std::max(turned, std::acos(std::clamp(L.normalized().dot(L0.normalized()), -1.0, 1.0)));
    if (i == 100) {
      // after one second L has turned with the body, about w
      const double across = p.start.y.cross(w).norm() / w.norm();
      EXPECT_NEAR((L - L0).norm(), 2.0 * across * std::sin(0.5 * w.norm()), 1e-13);
    }
  }
  expect_residual("G1 energy", std::abs(energy(p.model, frozen) - energy(p.model, p.start)), 1e-15);
  expect_residual("G1 |L|", std::abs(frozen.y.norm() - p.start.y.norm()), 1e-15);
  EXPECT_GT(turned, 0.7);
}

// A1: adaptive methods drift by their tolerance and do not come back; symmetric fixed steps do
TEST(WhereMethodsFail, A1AdaptiveMethodsDriftAndDoNotReturn) {
  const Problem p = hairer_vilmart();
  const double T = 68.6;
  const auto drift = [&](double duration, double tolerance) {
    const State end = adapted("dop853", p, duration, tolerance);
    return std::abs(energy(p.model, end) / energy(p.model, p.start) - 1.0);
  };
  EXPECT_NEAR(std::log10(drift(10 * T, 1e-8) / drift(10 * T, 1e-10)), 2.0, 0.7);
  EXPECT_NEAR(drift(10 * T, 1e-8) / drift(5 * T, 1e-8), 2.0, 0.5);  // linear in time
  const auto back = [&](const char* method) {
    Problem end{p.model, walked(method, p, 0.05, 1372)};
    return distance(walked(method, end, -0.05, 1372), p.start);
  };
  for (const char* method : {"dmv10", "symmetric_remainder2", "implicit_midpoint"})
    expect_residual(std::string("A1 way back ") + method, back(method), 1e-12);
  EXPECT_GT(back("rk4"), 1e-8);
}

// R1: round-off of energy over a million steps: a random walk for Moser-Veselov; one closed form
// from the start has none that grows
TEST(WhereMethodsFail, R1RoundOffWalksAndClosedFormsDoNot) {
  const Problem p = hairer_vilmart();
  const auto lost = [&](const State& s) {
    return std::abs(energy(p.model, s) / energy(p.model, p.start) - 1.0);
  };
  expect_residual("R1 dmv10, 1e6 steps", lost(walked("dmv10", p, 0.01, 1'000'000)), 1e-12);
  expect_residual("R1 one shot", lost(exact_asymmetric(p.model, p.start)->at(1e4)), 2e-14);
  // restarted at every step: still tiny, and no faster than linear at 1e-17 a step
  expect_residual("R1 restarted, 1e5 steps", lost(walked("kick_strang", p, 0.01, 100'000)), 1e-12);
}

// K1: the constants of Kovalevskaya (I1 = I2 = 2 I3, centre of mass in the plane of 1 and 2) and of
// Goryachev and Chaplygin (I1 = I2 = 4 I3, L about the vertical 0) hold at the order of a solver
TEST(WhereMethodsFail, K1ConstantsOfIntegrableTops) {
  const Problem kovalevskaya{heavy_body({2, 2, 1}, {1.0, 0, 0}),
                             {exp_rotation({0.4, 0.9, -0.3}), {1.2, -0.6, 0.8}}};
  const auto K = [&](const State& s, double sign) {
    // |(w1 + i w2)^2 - (chi / I3) (gamma1 + i gamma2)|^2, gamma up; the other sign is not constant
    const Vec3 w = angular_velocity(kovalevskaya.model, s.y);
    const Vec3 g = up_in_body(kovalevskaya.model, s.q);
    const double re = w[0] * w[0] - w[1] * w[1] + sign * g[0];
    const double im = 2.0 * w[0] * w[1] + sign * g[1];
    return re * re + im * im;
  };
  const auto drift = [&](const char* method, double h, long n, double sign = -1.0) {
    return std::abs(K(walked(method, kovalevskaya, h, n), sign) - K(kovalevskaya.start, sign));
  };
  EXPECT_GT(drift("taylor16", 0.05, 400, 1.0), 1e-3);
  expect_residual("K1 taylor16", drift("taylor16", 0.05, 400), 1e-12);
  const double coarse = drift("rk4", 0.08, 250), fine = drift("rk4", 0.04, 500);
  EXPECT_GT(coarse, 1e-9);
  EXPECT_NEAR(std::log2(coarse / fine), 4.5, 1.0);
  // Lagrange: the spin about the axis
  const Problem lagrange = gni_heavy_top();
  expect_residual("K1 y3",
                  std::abs(walked("kick_srkn11", lagrange, 0.1, 1000).y[2] - lagrange.start.y[2]),
                  1e-13);
}

// C1: on a chaotic top two good methods part at the Lyapunov rate while energy and L.up stay
TEST(WhereMethodsFail, C1ChaosPartsTwoGoodMethods) {
  const Problem p{heavy_body({0.6, 0.8, 1.0}, {0.3, -0.5, 0.7}),
                  {exp_rotation({0.4, 1.1, -0.3}), {0.3, 0.1, -0.2}}};
  const auto apart = [&](double T) {
    const auto n = std::lround(T / 0.02);
    return distance(walked("gauss6", p, 0.02, n), walked("kick_srkn11", p, 0.02, n));
  };
  const double early = apart(20.0), late = apart(1200.0);
  EXPECT_LT(early, 1e-8);
  EXPECT_GT(late, 0.1);
  for (const char* method : {"gauss6", "kick_srkn11"}) {
    const State end = walked(method, p, 0.02, 60'000);
    EXPECT_LT(std::abs(energy(p.model, end) - energy(p.model, p.start)), 1e-6) << method;
    EXPECT_LT(std::abs(momentum_in_space(end)[2] - momentum_in_space(p.start)[2]), 1e-6) << method;
  }
}

// L3: a fast top, with the step too long for its spin by RK4, is no trouble for kicks
TEST(WhereMethodsFail, L3SpinLimitsRungeKuttaNotKicks) {
  const Problem p{heavy_body({1, 1, 0.5}, 0.5 * Vec3::UnitZ()),
                  {exp_rotation({0.5, 0, 0}), {0.1, 0.0, 50.0}}};
  const double turn = 100.0 * (1.0 / 0.5 - 1.0) * 0.5;  // of the momentum in the body, rad/s
  const double h = 3.0 / turn;
  const State exact = TaylorOracle(p.model, p.start).at(200.0L * h);
  EXPECT_FALSE(distance(after("rk4", p, h, 200), exact) < 0.5);
  expect_residual("L3 kicks", distance(after("kick_srkn11", p, h, 200), exact), 6e-9);
}

// L4: a sleeping top falls over below w* = 2 sqrt(A mu) / C, at the rate sqrt(4 A mu - C^2 w^2) /
// 2A
TEST(WhereMethodsFail, L4SleepingTop) {
  const BodyModel model = heavy_body({1, 1, 0.5}, {0, 0, 1});
  const double critical = 4.0;
  const auto tilt_after = [&](double ratio, double t) {
    const double h = 0.005;
    const Problem p{model, {exp_rotation({1e-9, 0, 0}), {0, 0, 0.5 * ratio * critical}}};
    const std::unique_ptr<Stepper> rk4 = stepper("rk4", p);
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

// L5: kicks keep L.up to round-off and energy within a bound, for as long as one looks; RK4 loses
TEST(WhereMethodsFail, L5KicksDoNotDrift) {
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
}  // namespace polhode::test
