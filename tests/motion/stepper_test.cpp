// SPDX-License-Identifier: MIT
// One test kit for every method of the table: a new row is tested by being there.
#include "motion/stepper.h"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "motion/grid_trajectory.h"
#include "support/expect_error.h"
#include "support/residual.h"
#include "support/stepper_rows.h"
#include "support/taylor_oracle.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;

using EveryStepper = StepperTest;
INSTANTIATE_TEST_SUITE_P(Table, EveryStepper, every_stepper(), stepper_name);

// one free body and one that gravity turns, of which the method takes at least one
std::vector<Problem> problems_of(const StepperInfo& row) {
  std::vector<Problem> taken;
  for (const Problem& p : {hairer_vilmart(), heavy_asymmetric()}) {
    if (row.why_not(p.model).empty()) taken.push_back(p);
  }
  EXPECT_FALSE(taken.empty());
  return taken;
}

// the state after n steps of length h
State after(const StepperInfo& row, const Problem& p, double h, int n) {
  const std::unique_ptr<Stepper> stepper = row.make(p.model, momentum_scale(p.model, p.start));
  State s = p.start;
  for (int i = 0; i < n; ++i)
    stepper->step(i * h, h, s);
  return s;
}

// error ratio of two step sizes as an order; coarse enough that round-off does not show
double measured_order(const std::function<double(int)>& error, int order) {
  const double finest = 2e-13;
  int n = 4;
  while (!(error(n) < 1e-2) && n < (1 << 20))
    n *= 2;
  // as far into the asymptotic range as three digits above round-off allow
  while (error(2 * n) > finest * std::pow(2.0, order) && n < 4096)
    n *= 2;
  return std::log2(error(n) / error(2 * n));
}

TEST_P(EveryStepper, HasItsOrderOnAFreeAndOnAHeavyBody) {
  const StepperInfo& row = GetParam();
  for (const Problem& p : problems_of(row)) {
    const State exact = TaylorOracle(p.model, p.start).at(1.0L);
    const double order = measured_order(
        [&](int n) {
          // a step that has no solution is one that is too long
          try {
            return distance(after(row, p, 1.0 / n, n), exact);
          } catch (const Error&) {
            return std::numeric_limits<double>::infinity();
          }
        },
        row.order);
    EXPECT_NEAR(order, row.order, std::max(0.2, 0.04 * row.order));  // measured within two thirds
  }
}

TEST_P(EveryStepper, HasItsOrderBetweenTheGridTimesToo) {
  const StepperInfo& row = GetParam();
  const Problem p = problems_of(row).back();
  const double times[] = {0.1234567, 0.5432101, 0.987654321};
  std::vector<State> exact;
  TaylorOracle oracle(p.model, p.start);
  for (const double t : times)
    exact.push_back(oracle.at(t));
  const double order = measured_order(
      [&](int n) {
        double worst = 0.0;
        try {
          const auto grid = integrate_fixed(row, p.model, p.start, 1.0, 1.0 / n).trajectory;
          for (std::size_t i = 0; i < exact.size(); ++i)
            worst = worse(worst, distance(grid->at(times[i]), exact[i]));
        } catch (const Error&) {
          worst = std::numeric_limits<double>::infinity();
        }
        return worst;
      },
      row.order);
  EXPECT_NEAR(order, row.order, 0.35);  // where in its step a time lies changes the error a little
}

// what is conserved, and how far a method is from it after many large steps
struct Kept {
  double energy = 0.0;
  double norm = 0.0;   // |y|
  double space = 0.0;  // L, or its vertical part
};

Kept kept_over(const StepperInfo& row, const Problem& p, double h, int n) {
  const std::unique_ptr<Stepper> stepper = row.make(p.model, momentum_scale(p.model, p.start));
  const bool heavy = p.model.chi_P.norm() > 0.0;
  const Vec3 L0 = momentum_in_space(p.start);
  Kept worst;
  State s = p.start;
  for (int i = 0; i < n; ++i) {
    stepper->step(i * h, h, s);
    if (!s.y.allFinite() || !s.q.coeffs().allFinite()) return {1e300, 1e300, 1e300};
    const Vec3 change = momentum_in_space(s) - L0;
    const double space = heavy ? std::abs(change.dot(p.model.up_S)) : change.norm();
    worst.energy = worse(worst.energy, std::abs(energy(p.model, s) - energy(p.model, p.start)));
    worst.norm = worse(worst.norm, std::abs(s.y.norm() - p.start.y.norm()));
    worst.space = worse(worst.space, space);
  }
  return worst;
}

// round-off of a thousand steps is 1e-14 here, and what is not kept is lost a million times as much
constexpr double kRoundOff = 3e-13;
constexpr double kLost = 1e-8;

void expect_claim(const std::string& what, bool claimed, double drift) {
  if (claimed) {
    expect_residual(what + " kept", drift, kRoundOff);
  } else {
    expect_effect(what + " lost", drift, kLost);
  }
}

// what a method of high order loses shows only in longer steps
double longer(const StepperInfo& row) {
  return row.keeps_energy ? 1.0 : std::max(1.0, 0.8 * row.order);
}

TEST_P(EveryStepper, KeepsWhatTheTableClaimsAndNothingElse) {
  const StepperInfo& row = GetParam();
  const Problem free = hairer_vilmart();
  if (!row.why_not(free.model).empty()) GTEST_SKIP() << row.why_not(free.model);
  const double h = 0.25 * longer(row) / angular_velocity(free.model, free.start.y).norm();
  const Kept kept = kept_over(row, free, h, 1000);
  expect_claim(row.name + ": energy", row.keeps_energy, kept.energy);
  expect_claim(row.name + ": |y|", row.keeps_momentum_norm, kept.norm);
  expect_claim(row.name + ": L in space", row.keeps_momentum_space, kept.space);
}

TEST_P(EveryStepper, KeepsWhatTheTableClaimsOnAPivot) {
  const StepperInfo& row = GetParam();
  if (!row.why_not(heavy_asymmetric().model).empty()) GTEST_SKIP();
  const Kept kept = kept_over(row, heavy_asymmetric(), 0.1 * longer(row), 1000);
  expect_claim(row.name + ": energy, heavy", row.keeps_energy, kept.energy);
  expect_claim(row.name + ": L.up, heavy", row.keeps_momentum_space, kept.space);
}

TEST_P(EveryStepper, IsReversibleExactlyWhenTheTableSaysSo) {
  const StepperInfo& row = GetParam();
  for (const Problem& p : problems_of(row)) {
    const double h = 0.1;
    Problem turned = p;
    turned.start = after(row, p, h, 200);
    const double back = distance(after(row, turned, -h, 200), p.start);
    expect_claim(row.name + ": way back", row.reversible, back);
  }
}

TEST_P(EveryStepper, StaysOnTheUnitSphere) {
  const StepperInfo& row = GetParam();
  const Problem p = problems_of(row).front();
  const std::unique_ptr<Stepper> stepper = row.make(p.model, 1.0);
  State s = p.start;
  double worst = 0.0;
  for (int i = 0; i < 300; ++i) {
    stepper->step(0.02 * i, 0.02, s);
    worst = worse(worst, std::abs(s.q.norm() - 1.0));
  }
  expect_residual(row.name + ": |q| = 1", worst, 4e-16);
}

TEST_P(EveryStepper, LeavesABodyAtRestAtRest) {
  const Model model = free_body({0.6, 0.8, 1.0});
  if (!GetParam().why_not(model).empty()) GTEST_SKIP();
  const State rest{exp_rotation({0.3, 0.2, 0.1}), Vec3::Zero()};
  State s = rest;
  const std::unique_ptr<Stepper> stepper = GetParam().make(model, 1.0);
  for (int i = 0; i < 10; ++i)
    stepper->step(0.0, 0.1, s);
  EXPECT_LE(distance(s, rest), 1e-15);
  EXPECT_EQ(s.y.norm(), 0.0);
}

TEST_P(EveryStepper, CountsItsWorkAndKeepsNoState) {
  const StepperInfo& row = GetParam();
  const Problem p = problems_of(row).back();
  const std::unique_ptr<Stepper> stepper = row.make(p.model, 1.0);
  State first = p.start;
  stepper->step(0.0, 0.1, first);
  const long work = stepper->evaluations();
  EXPECT_GT(work, 0);
  State other = hairer_vilmart().start;
  stepper->step(0.0, 0.1, other);
  State second = p.start;
  stepper->step(0.0, 0.1, second);
  EXPECT_TRUE(same_bits(first, second));
  EXPECT_GT(stepper->evaluations(), work);
}

TEST_P(EveryStepper, NeverFormsTheInverseOfARotatorsMissingMoment) {
  const Problem p{free_body({1, 1, 0}), {Quat::Identity(), {0.3, 1.2, 0.0}}};
  if (!GetParam().why_not(p.model).empty()) GTEST_SKIP() << GetParam().why_not(p.model);
  const State s = after(GetParam(), p, 1e-3, 100);
  EXPECT_TRUE(s.q.coeffs().allFinite());
  // no torque, and y x w = 0; splittings turn it there and back
  EXPECT_LE((s.y - p.start.y).norm(), 1e-7);
}

TEST(StepperTable, FindsByNameAndSuggestsTheNearest) {
  EXPECT_EQ(find_stepper("rk4").order, 4);
  expect_input_error([] { find_stepper("rk44"); }, "", "rk4");
}

// the estimate of an adaptive method bounds what the step really did wrong, and is not wild
TEST(AdaptiveSteppers, EstimateTheirLocalError) {
  const Problem p = heavy_asymmetric();
  const State exact = TaylorOracle(p.model, p.start).at(0.1L);
  for (const StepperInfo& row : stepper_table()) {
    if (!row.adaptive) continue;
    State s = p.start;
    const double scale = momentum_scale(p.model, p.start);
    const double estimate = row.make(p.model, scale)->step_with_error(0.0, 0.1, s);
    const double error =
        std::hypot((s.q.coeffs() - exact.q.coeffs()).norm(), (s.y - exact.y).norm() / scale);
    EXPECT_GE(estimate, error);
    EXPECT_LE(estimate, 1e4 * error);
  }
}

}  // namespace
}  // namespace polhode
