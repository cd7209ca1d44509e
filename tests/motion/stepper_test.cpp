// SPDX-License-Identifier: MIT
// One test kit for every method of the table: a new row is tested by being there.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "motion/grid_trajectory.h"
#include "motion/scales.h"
#include "motion/stepper_table.h"
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

// the state after n steps of length h
State after(const StepperInfo& row, const Problem& p, double h, int n) {
  const std::unique_ptr<Stepper> stepper = row.make(p.model, momentum_scale(p.model, p.start));
  State s = p.start;
  for (int i = 0; i < n; ++i)
    stepper->step(i * h, h, s);
  return s;
}

// what `measure` finds, or `failed` where a step has no solution
double unless_unsolved(double failed, const std::function<double()>& measure) {
  try {
    return measure();
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), Fault::check_failed) << error.what();
    return failed;
  }
}

// the distance to an exact state, or one radian where a step has no solution
double distance_or_far(
    const StepperInfo& row, const Problem& p, double h, int n, const State& exact) {
  return unless_unsolved(1.0, [&] { return distance(after(row, p, h, n), exact); });
}

// error ratio of two step sizes as an order; coarse enough that round-off does not show
double measured_order(const std::function<double(int)>& error, const StepperInfo& row) {
  // round-off: that of many short steps, of many turns in a step, of a Runge-Kutta step
  const double finest = row.order < 5 ? 1e-12 : row.adaptive ? 1e-14 : 5e-14;
  int n = 4;
  while (error(n) > 1e-2 && n < (1 << 20))
    n *= 2;
  // as far into the asymptotic range as three digits above round-off allow
  while (error(2 * n) > finest * std::pow(2.0, row.order) && n < 4096)
    n *= 2;
  return std::log2(error(n) / error(2 * n));
}

// the same from single steps, for orders so high that many steps are round-off or far off
double measured_local_order(const StepperInfo& row, const Problem& p) {
  const auto error = [&](double h) {
    return distance(after(row, p, h, 1), TaylorOracle(p.model, p.start).at(h));
  };
  double h = 1.0;
  while (error(h) > 2e-10)
    h *= 0.98;
  const double ratio = 0.75;
  return std::log(error(h) / error(ratio * h)) / std::log(1.0 / ratio) - 1.0;
}

// the problems that a method is measured on: without and with gravity, with and without symmetry
std::vector<Problem> problems_for(const StepperInfo& row) {
  std::vector<Problem> problems;
  for (const Problem& p : {upright(hairer_vilmart()), heavy_asymmetric(), gni_heavy_top()}) {
    if (why_not(row, p.model).empty()) problems.push_back(p);
  }
  return problems;
}

bool is_free(const Problem& p) {
  return p.model.chi_P.norm() == 0.0;
}

TEST_P(EveryStepper, HasItsOrder) {
  const StepperInfo& row = GetParam();
  for (const Problem& p : problems_for(row)) {
    const State exact = TaylorOracle(p.model, p.start).at(3.0L);
    const auto error = [&](int n) {
      return distance_or_far(row, p, 3.0 / n, n, exact);
    };
    if (row.exact_when_free && is_free(p)) {
      expect_residual(row.name + ": one step for all", error(1), 1e-14);
      continue;
    }
    if (row.order >= 10 && row.adaptive) {
      EXPECT_NEAR(measured_local_order(row, p), row.order, 0.06 * row.order) << is_free(p);
      continue;
    }
    EXPECT_NEAR(measured_order(error, row), row.order, 0.35) << is_free(p);
  }
}

TEST_P(EveryStepper, HasItsOrderBetweenTheGridTimesToo) {
  const StepperInfo& row = GetParam();
  const Problem p = problems_for(row).size() > 1 ? heavy_asymmetric() : upright(hairer_vilmart());
  const double times[] = {0.1234567, 0.5432101, 0.987654321, 1.9753086};
  std::vector<State> exact;
  TaylorOracle oracle(p.model, p.start);
  for (const double t : times)
    exact.push_back(oracle.at(t));
  const double order = measured_order(
      [&](int n) {
        return unless_unsolved(1.0, [&] {
          const auto grid = integrate_fixed(row, p.model, p.start, 2.0, 2.0 / n).trajectory;
          double worst = 0.0;
          for (std::size_t i = 0; i < exact.size(); ++i)
            worst = worse(worst, distance(grid->at(times[i]), exact[i]));
          return worst;
        });
      },
      row);
  EXPECT_NEAR(order, row.order, 0.6);  // where in its step a time lies changes the error a little
}

constexpr double kFar = 1e300;  // of what ran away or has no solution

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
    try {
      stepper->step(i * h, h, s);
    } catch (const Error&) {
      return {kFar, kFar, kFar};
    }
    if (!s.y.allFinite() || !s.q.coeffs().allFinite()) return {kFar, kFar, kFar};
    const Vec3 change = momentum_in_space(s) - L0;
    const double space = heavy ? std::abs(change.dot(p.model.up_S)) : change.norm();
    worst.energy = worse(worst.energy, std::abs(energy(p.model, s) - energy(p.model, p.start)));
    worst.norm = worse(worst.norm, std::abs(s.y.norm() - p.start.y.norm()));
    worst.space = worse(worst.space, space);
  }
  return worst;
}

// round-off of a thousand steps is 1e-14 here, and what is not kept is lost thousands of times as
// much
constexpr double kRoundOff = 2e-13;
constexpr double kLost = 1e-9;

void expect_claim(const std::string& what, bool claimed, double drift) {
  if (claimed) {
    expect_residual(what + " kept", drift, kRoundOff);
  } else {
    expect_effect(what + " lost", drift, kLost);
  }
}

// a step, as an angle, that is large for the method: errors of high orders must show too
double large_turn(const StepperInfo& row) {
  const bool all = row.keeps_energy && row.keeps_momentum_norm && row.keeps_momentum_space;
  return all || row.order < 6 ? 0.25 : row.order <= 10 ? 1.2 : 3.5;
}

TEST_P(EveryStepper, KeepsWhatTheTableClaimsAndNothingElse) {
  const StepperInfo& row = GetParam();
  const Problem free = upright(hairer_vilmart());
  const double h = large_turn(row) / angular_velocity(free.model, free.start.y).norm();
  const Kept kept = kept_over(row, free, h, 1000);
  expect_claim(row.name + ": energy", row.keeps_energy || row.exact_when_free, kept.energy);
  expect_claim(row.name + ": |y|", row.keeps_momentum_norm, kept.norm);
  expect_claim(row.name + ": L in space", row.keeps_momentum_space, kept.space);
}

TEST_P(EveryStepper, KeepsWhatTheTableClaimsOnAPivot) {
  const StepperInfo& row = GetParam();
  const Problem p = heavy_asymmetric();
  if (!row.takes_heavy) {
    EXPECT_NE(why_not(row, p.model).find("gravity"), std::string::npos);
    return;
  }
  const double h = large_turn(row) / angular_velocity(p.model, p.start.y).norm();
  const Kept kept = kept_over(row, p, h, 1000);
  expect_claim(row.name + ": energy, heavy", row.keeps_energy, kept.energy);
  expect_claim(row.name + ": L.up, heavy", row.keeps_momentum_space, kept.space);
}

TEST_P(EveryStepper, IsReversibleExactlyWhenTheTableSaysSo) {
  const StepperInfo& row = GetParam();
  for (const Problem& p : problems_for(row)) {
    const double h = row.reversible ? 0.1 : 0.5 * large_turn(row);
    double back = unless_unsolved(kFar, [&] {
      Problem turned = p;
      turned.start = after(row, p, h, 200);
      return distance(after(row, turned, -h, 200), p.start);
    });
    if (std::isnan(back)) back = row.reversible ? back : kFar;
    if (row.reversible) {
      expect_residual(row.name + ": way back", back, 6e-13);
    } else {
      expect_effect(row.name + ": no way back", back, kLost);
    }
  }
}

TEST_P(EveryStepper, StaysOnTheUnitSphere) {
  const StepperInfo& row = GetParam();
  const std::unique_ptr<Stepper> stepper = row.make(hairer_vilmart().model, 1.0);
  State s = upright(hairer_vilmart()).start;
  double worst = 0.0;
  for (int i = 0; i < 300; ++i) {
    stepper->step(0.02 * i, 0.02, s);
    worst = worse(worst, std::abs(s.q.norm() - 1.0));
  }
  expect_residual(row.name + ": |q| = 1", worst, 4e-16);
}

TEST_P(EveryStepper, LeavesABodyAtRestAtRest) {
  const BodyModel model = free_body({0.6, 0.8, 1.0});
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
  const Problem p = problems_for(row).back();
  const std::unique_ptr<Stepper> stepper = row.make(p.model, 1.0);
  State first = p.start;
  Work work;
  stepper->step(0.0, 0.1, first, work);
  EXPECT_GT(work.evaluations, 0);
  State other = upright(hairer_vilmart()).start;
  stepper->step(0.0, 0.3, other);
  State second = p.start;
  stepper->step(0.0, 0.1, second);
  EXPECT_TRUE(same_bits(first, second));
}

TEST_P(EveryStepper, NeverFormsTheInverseOfARotatorsMissingMoment) {
  const Problem p{free_body({1, 1, 0}), {exp_rotation({1.5, 0.2, 0.1}), {0.3, 1.2, 0.0}}};
  if (!GetParam().takes_rotator) {
    EXPECT_NE(why_not(GetParam(), p.model).find("line"), std::string::npos);
    return;
  }
  const State s = after(GetParam(), p, 1e-3, 100);
  EXPECT_TRUE(s.q.coeffs().allFinite());
  EXPECT_LE((s.y - p.start.y).norm(), 3e-14);  // no torque, and y x w = 0
}

// the estimate of an adaptive method bounds what the step really did wrong, and is not wild
TEST(AdaptiveSteppers, EstimateTheirLocalError) {
  const Problem p = heavy_asymmetric();
  for (const StepperInfo& row : stepper_table()) {
    if (!row.adaptive) continue;
    const double h = row.order < 10 ? 0.1 : 0.8;
    const State exact = TaylorOracle(p.model, p.start).at(h);
    State s = p.start;
    const double scale = momentum_scale(p.model, p.start);
    Work work;
    const double estimate = row.make(p.model, scale)->step_with_error(0.0, h, s, work);
    const double error =
        std::hypot((s.q.coeffs() - exact.q.coeffs()).norm(), (s.y - exact.y).norm() / scale);
    EXPECT_GE(estimate, error);
    EXPECT_LE(estimate, 1e4 * error);
  }
}

}  // namespace
}  // namespace polhode
