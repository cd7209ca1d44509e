// SPDX-License-Identifier: MIT
// Methods that hold a body on a table without events, against motions from event to event: how each
// fails. The numbers are those that docs/where-methods-fail.md tells.
#include <cmath>

#include <gtest/gtest.h>

#include "motion/deviation.h"
#include "motion/solution_method.h"
#include "support/on_table.h"

namespace polhode::test {
namespace {

struct OnTableProblem {
  BodySpec body;
  MotionSpec motion;
  BodyModel model() const { return with_needed_degrees(make_model(body, motion)); }
};

Integration run_of(const OnTableProblem& p, const char* method, double fineness) {
  const BodyModel model = p.model();
  return integrate_with(
      find_stepper(method), model, start_state(model, p.motion), p.motion.duration, fineness);
}

// at the end, rad
double error_of(const OnTableProblem& p, const char* method, double step) {
  const double T = p.motion.duration;
  return deviation(p.model(),
                   run_of(p, method, step).trajectory->at(T),
                   run_of(p, "dop853", 1e-12).trajectory->at(T));
}

double energy_at(const OnTableProblem& p, const Integration& run, double t) {
  return energy(p.model(), run.trajectory->at(t));
}

OnTableProblem rolling_disc(double duration = 0.5) {
  OnTableProblem p{disc_body(), on_table(duration, rolling())};
  p.motion.attitude.zxz = Vec3(0, 1.3, 0);
  p.motion.spin.rates = Vec3(2, 0, 18);
  return p;
}

OnTableProblem sliding_ball(double duration = 0.5) {
  OnTableProblem p{ball_body(), on_table(duration, coulomb(0.2))};
  p.motion.velocity = Vec3(1, 0, 0);
  p.motion.spin.space = Vec3(20, 10, 30);
  return p;
}

// between two steps the body moves on with the velocities of the step, however short the time is
TEST(TableSteppers, ImpulsesActOnceInAStep) {
  const OnTableProblem p = rolling_disc();
  const double h = 0.001;
  for (const char* method : {"table_baumgarte", "table_baumgarte_hard", "table_projection"}) {
    const Integration run = run_of(p, method, h);
    for (const double part : {1e-12, 1e-6, 0.3, 0.999}) {
      for (const int step : {0, 7, 400}) {
        const double after = energy_at(p, run, h * (step + 1));
        // within a step it falls or rises, which at this speed is little
        EXPECT_NEAR(energy_at(p, run, h * (step + part)), after, 0.01 * std::abs(after))
            << method << ' ' << step << ' ' << part;
      }
    }
    const State end = run.trajectory->at(h * 8.0);
    const State before = run.trajectory->at(h * 8.0 - 1e-10);
    EXPECT_LT((end.place_S - before.place_S).norm(), 1e-8) << method;
  }
}

// on a smooth motion its order is that of the book
TEST(TableSteppers, RungeKuttaHasItsOrderWithoutEvents) {
  const double coarse = error_of(rolling_disc(), "table_rk4", 0.002);
  const double fine = error_of(rolling_disc(), "table_rk4", 0.001);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.3) << coarse << " " << fine;
}

// the ball stops slipping within a step: the error falls with the step, not with its fourth power
TEST(TableSteppers, AMissedEventCostsTheOrder) {
  double worst = 0.0;
  for (const double h : {0.01, 0.0071, 0.0053}) {
    const double error = error_of(sliding_ball(), "table_rk4", h);
    worst = std::max(worst, error / h);
  }
  EXPECT_GT(worst, 0.01) << "rad per s of step";
  EXPECT_LT(worst, 30.0);
}

// accelerations alone do not hold the contact: it leaves the table, and the energy changes
TEST(TableSteppers, EulerDriftsOffTheTable) {
  const OnTableProblem p = rolling_disc();
  const auto gap_after = [&](double h) {
    const Integration run = run_of(p, "table_euler", h);
    const State s = run.trajectory->at(p.motion.duration);
    const BodyModel model = p.model();
    const Moving now = moving_of(model, s);
    return std::abs(gap_of(model, Touch{}, now));
  };
  const double coarse = gap_after(1e-3), fine = gap_after(5e-4);
  EXPECT_GT(coarse, 1e-5);
  EXPECT_GT(coarse, 1.3 * fine);
  const Integration run = run_of(p, "table_euler", 1e-3);
  const double change = energy_at(p, run, p.motion.duration) / energy_at(p, run, 0.0) - 1.0;
  EXPECT_GT(std::abs(change), 0.002) << change;
  EXPECT_LT(std::abs(change), 0.02) << change;
}

// what dry friction holds creeps where it is smoothed, however short the steps
TEST(TableSteppers, SmoothedFrictionCreeps) {
  OnTableProblem p{ball_body(), on_table(2.0, coulomb(0.2))};
  p.motion.friction->turntable = 3.0;
  p.motion.position = Vec3(0.2, 0, 0);
  const double coarse = error_of(p, "table_smoothed", 1e-3);
  const double fine = error_of(p, "table_smoothed", 1e-4);
  EXPECT_GT(fine, 0.01);
  EXPECT_NEAR(coarse / fine, 1.0, 0.5) << coarse << " " << fine;
}

// springs, gains and put-back positions do work that no law of friction knows
TEST(TableSteppers, EnginesDoNotKeepTheEnergyOfADisc) {
  const OnTableProblem p = rolling_disc(1.0);
  for (const char* method :
       {"table_penalty", "table_baumgarte", "table_baumgarte_hard", "table_projection"}) {
    const Integration run = run_of(p, method, 1.0 / 240.0);
    const double change = energy_at(p, run, 1.0) / energy_at(p, run, 0.0) - 1.0;
    RecordProperty(method, std::to_string(change));
    EXPECT_GT(std::abs(change), 1e-3) << method << " " << change;
    EXPECT_LT(std::abs(error_of(p, method, 1e-5)), std::abs(error_of(p, method, 1e-3))) << method;
  }
}

TEST(TableSteppers, AreForTablesOnly) {
  const BodyModel free = make_model(ball_body(), MotionSpec{});
  for (const StepperInfo& row : stepper_table()) {
    if (!row.only_table) continue;
    EXPECT_NE(why_not(row, free).find("is for bodies on a table"), std::string::npos) << row.name;
    EXPECT_EQ(why_not(row, rolling_disc().model()), "") << row.name;
    BodyModel bouncing = rolling_disc().model();
    bouncing.table->friction.restitution = 0.5;
    EXPECT_EQ(why_not(row, bouncing).empty(), row.name == "table_rk4") << row.name;
  }
}

}  // namespace
}  // namespace polhode::test
