// SPDX-License-Identifier: MIT
#include "motion/recorded.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "math/so3.h"
#include "motion/derived.h"
#include "support/motions.h"
#include "support/on_table.h"

namespace polhode::test {
namespace {

std::vector<double> recorded(const std::string& name, const Motion& motion, double t) {
  const Recorded* row = find_recorded(name);
  if (row != nullptr) return row->values(motion, motion.at(t));
  ADD_FAILURE() << name;
  return {};
}

Vec3 vector(const std::vector<double>& values) {
  EXPECT_EQ(values.size(), 3U);
  return values.size() == 3 ? Vec3(values[0], values[1], values[2]) : Vec3::Zero();
}

TEST(Recorded, EveryRowHasANameOfItsOwnAndAValueForEachCurve) {
  const Motion motion = moving(prolate_body(), wobbling());
  std::set<std::string> names;
  for (const Recorded& row : recorded_quantities()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(row.values(motion, motion.at(1.0)).size(), row.curves.size()) << row.name;
    EXPECT_FALSE(row.title.empty()) << row.name;
  }
  const std::vector<std::string> listed = recorded_names();
  EXPECT_EQ(std::set<std::string>(listed.begin(), listed.end()), names);
}

TEST(Recorded, ForcesOfATableNeedATable) {
  const Motion motion = moving(prolate_body(), wobbling());
  for (const char* name : {"contact_force", "slip", "jellett"}) {
    EXPECT_EQ(why_not(*find_recorded(name), motion), "needs a body on a table") << name;
    for (const double value : recorded(name, motion, 1.0))
      EXPECT_TRUE(std::isnan(value)) << name;
  }
  EXPECT_EQ(why_not(*find_recorded("tilt"), motion), "");
}

// methods without events know neither forces nor whether the body touches
TEST(Recorded, ForcesOfATableNeedEvents) {
  const MotionSpec spec = on_table(1.0, rolling());
  const BodyModel model = make_model(ball_body(), spec);
  NumericsSpec numerics;
  numerics.method = "table_euler";
  numerics.step = 1e-3;
  const Motion simple = simulate(model, spec, numerics, 0.1).motion;
  const Motion exact = simulate(model, spec, {}, 0.1).motion;
  for (const char* name : {"contact_force", "slip", "jellett"}) {
    EXPECT_NE(why_not(*find_recorded(name), simple), "") << name;
    EXPECT_EQ(why_not(*find_recorded(name), exact), "") << name;
    EXPECT_TRUE(std::isnan(recorded(name, simple, 0.5)[0])) << name;
  }
}

// what rolls does not slip, not even by rounding errors
TEST(Recorded, WhatRollsDoesNotSlip) {
  MotionSpec spec = on_table(1.0, coulomb(0.3));
  spec.spin.space = Vec3(3.0, -20.0, 5.0);
  spec.velocity = 0.028 * Vec3(-20.0, -3.0, 0.0);
  const Motion motion = simulated(ball_body(), spec).motion;
  for (const double t : {0.0, 0.3, 1.0})
    EXPECT_EQ(recorded("slip", motion, t)[0], 0.0) << t;
}

TEST(Recorded, OmegaAndMomentumInBothAxes) {
  const MotionSpec spec = wobbling();
  const Motion motion = moving(brick_body(), spec);
  EXPECT_LE((vector(recorded("omega", motion, 0.0)) - *spec.spin.body).norm(), 1e-14);
  const Vec3 L = vector(recorded("momentum", motion, 0.0));
  for (const double t : {0.0, 1.7, 4.0}) {
    const Quat q = motion.at(t).q_SB;
    const Vec3 w_B = vector(recorded("omega", motion, t));
    EXPECT_LE((vector(recorded("omega_space", motion, t)) - q * w_B).norm(), 1e-13);
    // free: L rests in space, and in the body it is the tensor times omega
    EXPECT_LE((vector(recorded("momentum", motion, t)) - L).norm(), 1e-13 * L.norm());
    const Vec3 L_B = motion.model().body.tensor * w_B;
    EXPECT_LE((vector(recorded("momentum_body", motion, t)) - L_B).norm(), 1e-13 * L.norm());
  }
}

TEST(Recorded, AnglesAreInDegrees) {
  const Motion motion = moving(prolate_body(), wobbling());
  const Vec3 angles = vector(recorded("euler_angles", motion, 0.0));
  const Vec3 wanted = wobbling().attitude.zxz.value() * 180.0 / kPi;
  EXPECT_LE((angles - wanted).norm(), 1e-12);
  // the third axis is that of symmetry: its tilt is theta
  for (const double t : {0.0, 1.3}) {
    EXPECT_NEAR(
        recorded("tilt", motion, t).at(0), recorded("euler_angles", motion, t).at(1), 1e-11);
  }
}

// of a body that hangs, as of one that stands, the axis leads to the centre of mass: what is drawn,
// plotted and told by `inspect` is the same angle
TEST(Recorded, TheTiltIsThatOfTheCentreOfMass) {
  BodySpec rod = prolate_body();
  rod.pivot = Vec3(0.0, 0.0, 0.05);
  MotionSpec spec = spinning_on_pivot();
  spec.attitude.zxz = Vec3(0.0, 0.1, 0.0);
  const Motion motion = moving(rod, spec);
  EXPECT_NEAR(recorded("tilt", motion, 0.0).at(0), 180.0 - 0.1 * 180.0 / kPi, 1e-11);
  const std::optional<double> told =
      value_of(derived_quantities(motion.model(), spec), "tilt_at_start_rad");
  ASSERT_TRUE(told);
  EXPECT_NEAR(*told, kPi - 0.1, 1e-13);
}

// upright, phi and psi have no values of their own
TEST(Recorded, AnglesOfAnUprightAxisAreNone) {
  MotionSpec upright = wobbling();
  upright.attitude.zxz = Vec3(0.3, 0.0, 0.2);
  const std::vector<double> angles = recorded("euler_angles", moving(prolate_body(), upright), 0.0);
  EXPECT_TRUE(std::isnan(angles.at(0)));
  EXPECT_EQ(angles.at(1), 0.0);
  EXPECT_TRUE(std::isnan(angles.at(2)));
}

TEST(Recorded, RatesAreThoseOfTheAngles) {
  const Motion motion = moving(prolate_body(), wobbling());
  const double t = 1.3, h = 1e-5;
  const Vec3 change = vector(recorded("euler_angles", motion, t + h)) -
                      vector(recorded("euler_angles", motion, t - h));
  const Vec3 rates = vector(recorded("euler_rates", motion, t));
  EXPECT_LE((change * kPi / 180.0 / (2.0 * h) - rates).norm(), 1e-7);
  const double turned =
      recorded("azimuth", motion, t + h).at(0) - recorded("azimuth", motion, t - h).at(0);
  EXPECT_NEAR(turned, change[0], 1e-8) << "the axis goes round with phi";
}

// rings turn about a vertical that leans, angles and their rates are about Z
TEST(Recorded, RatesInGimbalsAreThoseOfTheAngles) {
  MotionSpec spec = spinning_on_pivot();
  spec.gravity = Vec3(3, 0, -9);
  GimbalsSpec gimbals;
  gimbals.outer = 0.001;
  spec.gimbals = gimbals;
  const Motion motion = moving(cone_body(), spec);
  const double t = 0.2, h = 1e-5;
  const Vec3 change = vector(recorded("euler_angles", motion, t + h)) -
                      vector(recorded("euler_angles", motion, t - h));
  const Vec3 rates = vector(recorded("euler_rates", motion, t));
  EXPECT_LE((change * kPi / 180.0 / (2.0 * h) - rates).norm(), 1e-4);
}

TEST(Recorded, EnergyIsKineticAndPotential) {
  const Motion top = moving(cone_body(), spinning_on_pivot());
  const double m = 0.1, g = gravity_of(spinning_on_pivot()).norm(),
               length = 0.75 * 0.05;  // of a cone's centre
  const std::vector<double> start = recorded("energy", top, 0.0);
  for (const double t : {0.0, 0.4, 2.0}) {
    const std::vector<double> now = recorded("energy", top, t);
    ASSERT_EQ(now.size(), 3U);
    EXPECT_DOUBLE_EQ(now[0], now[1] + now[2]);
    EXPECT_NEAR(now[0], start[0], 1e-12 * start[0]);
    const double tilt = recorded("tilt", top, t).at(0) * kPi / 180.0;
    EXPECT_NEAR(now[2], m * g * length * std::cos(tilt), 1e-12) << t;
  }
}

TEST(Recorded, DriftIsThatOfTheMotion) {
  const Motion motion = moving(brick_body(), wobbling());
  const std::vector<double> now = recorded("drift", motion, 3.0);
  const Drift wanted = drift_at(motion, 3.0);
  EXPECT_EQ(now.at(0), wanted.energy.value());
  EXPECT_EQ(now.at(1), wanted.momentum.value());
}

TEST(Recorded, DriftNeedsSomethingThatIsConserved) {
  const Recorded& drift = *find_recorded("drift");
  MotionSpec damped = wobbling();
  EXPECT_EQ(why_not(drift, moving(brick_body(), damped)), "");
  LoadSpec load;
  load.kind = "damping";
  load.c = 0.1;
  load.of = "spin";
  damped.torque = {load};
  EXPECT_NE(why_not(drift, moving(brick_body(), damped)).find("needs a motion that keeps"),
            std::string::npos);
}

// the curve has the name of what the motion conserves
TEST(Recorded, DriftNamesWhatIsConserved) {
  const auto name = [](const BodySpec& body, const MotionSpec& spec) {
    const Motion motion = moving(body, spec);
    const std::vector<std::string> names = curve_names(*find_recorded("drift"), motion);
    EXPECT_EQ(names.size(), 2U);
    EXPECT_EQ(names.front(), "energy");
    return names.back();
  };
  EXPECT_EQ(name(brick_body(), wobbling()), "L");
  EXPECT_EQ(name(cone_body(), spinning_on_pivot()), "L about the vertical");
  const MotionSpec rolls = on_table(1.0, rolling());
  EXPECT_EQ(name(ball_body(), rolls), "constants of motion") << "a homogeneous ball has many";
  EXPECT_EQ(name(tippe_top_body(), rolls), "Jellett, Routh");
  EXPECT_EQ(name(tippe_top_body(), on_table(1.0, coulomb(0.3))), "Jellett");
  for (const Recorded& row : recorded_quantities()) {
    const Motion motion = moving(brick_body(), wobbling());
    EXPECT_EQ(curve_names(row, motion).size(), row.curves.size()) << row.name;
  }
}

TEST(Recorded, PositionFollowsTheFlight) {
  MotionSpec spec = wobbling();
  spec.position = Vec3(1, 2, 3);
  spec.velocity = Vec3(0.5, 0, -1);
  spec.gravity = Vec3(0, 0, -9.81);
  const Motion motion = moving(brick_body(), spec);
  const Vec3 wanted = spec.position + 2.0 * spec.velocity + 2.0 * *spec.gravity;
  EXPECT_LE((vector(recorded("position", motion, 2.0)) - wanted).norm(), 1e-12);
}

// angles begin again at half a turn, and no line goes back through the whole plot
TEST(Recorded, AnglesStayWithinATurnAndJumpWithoutALine) {
  MotionSpec spec = wobbling();
  spec.spin.body = Vec3(0.1, 0.2, 20.0);
  const Motion motion = moving(prolate_body(), spec);
  for (const Recorded& row : recorded_quantities()) {
    if (row.name != "euler_angles") continue;
    const auto curves = values_over_time(row, motion, 4.0, 1000);
    ASSERT_EQ(curves.size(), 3U);
    int gaps = 0;
    for (std::size_t i = 1; i < curves[2].size(); ++i) {
      gaps += std::isnan(curves[2][i]) ? 1 : 0;
      if (std::isnan(curves[2][i]) || std::isnan(curves[2][i - 1])) continue;
      EXPECT_LE(std::abs(curves[2][i]), 180.0);
      EXPECT_LT(std::abs(curves[2][i] - curves[2][i - 1]), 10.0) << i;
    }
    // 20 rad/s for 4 s
    EXPECT_NEAR(gaps, 80.0 / (2.0 * kPi), 3.0);
  }
}

// a body that turns a thousand times has more steps than a curve of a wobble
TEST(Recorded, AFastMotionIsLookedAtOften) {
  MotionSpec spec = wobbling();
  spec.duration = 10.0;
  spec.spin = {};
  spec.spin.body = Vec3(0, 0, 0.1);
  EXPECT_EQ(steps_to_show(moving(prolate_body(), spec), 10.0, 2400), 2400);
  spec.spin.body = Vec3(0, 0, 2000.0 * kPi);  // 1000 turns a second
  EXPECT_EQ(steps_to_show(moving(prolate_body(), spec), 10.0, 2400), 99'999) << "ten in a turn";
  spec.spin.body = Vec3(0, 0, 4000.0 * kPi);
  EXPECT_EQ(steps_to_show(moving(prolate_body(), spec), 10.0, 2400), 100'000) << "too few";
  spec.spin.body = Vec3(0, 0, 40.0 * kPi);
  EXPECT_NEAR(steps_to_show(moving(prolate_body(), spec), 10.0, 2400), 200 * 24, 1);
}

// so have a fast load and a short pulse, though the body hardly turns
TEST(Recorded, FastLoadsAreLookedAtOften) {
  MotionSpec spec = wobbling();
  spec.duration = 10.0;
  spec.spin = {};
  spec.spin.body = Vec3(0, 0, 0.1);
  LoadSpec load;
  load.kind = "constant";
  load.body = Vec3(0, 0, 1e-3);
  load.rate = 40.0 * kPi;
  spec.torque = {load};
  EXPECT_NEAR(steps_to_show(moving(prolate_body(), spec), 10.0, 2400), 200 * 24, 1);
  load.rate.reset();
  load.from = 5.0;
  load.until = 5.01;
  spec.torque = {load};
  EXPECT_NEAR(steps_to_show(moving(prolate_body(), spec), 10.0, 2400), 12'000, 1);
}

// fewer values reach as far up and down, and leave gaps where there were a few
// A pendulum that all but stays in a plane passes close by the vertical: its azimuth goes half
// round at once. At the lowest place, which it passes at the speed v of energy, L_z = m l^2 sin^2
// phi'.
TEST(Recorded, PeaksBetweenStepsAreDrawn) {
  const Recorded& rates = *find_recorded("euler_rates");
  MotionSpec spec = test::spinning_on_pivot();
  spec.duration = 10.0;
  spec.attitude = {};
  spec.attitude.zxz = Vec3(0.0, 2.0, 0.0);
  spec.spin = {};
  spec.spin.space = Vec3(0.0, 0.0, 1e-3);
  const Motion motion = test::moving(test::cone_body(), spec);
  const int steps = 2400;
  const auto seen = values_over_time(rates, motion, spec.duration, steps);
  auto drawn = seen;
  add_peaks(rates, motion, spec.duration, drawn);
  const auto most = [](const std::vector<double>& values) {
    return *std::max_element(
        values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  };
  // of the peaks near the largest value that is drawn, by looks that are much closer
  double peak = 0.0;
  std::size_t passages = 0;
  for (std::size_t i = 1; i + 1 < drawn[0].size(); ++i) {
    if (std::abs(drawn[0][i]) < 0.5 * std::abs(most(drawn[0]))) continue;
    ++passages;
    for (int k = -20'000; k <= 20'000; ++k) {
      const double t = spec.duration * (static_cast<double>(i) + k / 20'000.0) / steps;
      peak = std::max(peak, std::abs(rates.values(motion, motion.at(t))[0]));
    }
    break;
  }
  EXPECT_GT(passages, 0U);
  EXPECT_GT(peak, 5.0 * std::abs(most(seen[0]))) << "between the steps";
  EXPECT_NEAR(std::abs(most(drawn[0])), peak, 0.02 * peak);
  // what is smooth stays as it is
  const Recorded& of_tilt = *find_recorded("tilt");
  auto tilt = values_over_time(of_tilt, motion, spec.duration, steps);
  const auto before = tilt;
  add_peaks(of_tilt, motion, spec.duration, tilt);
  double change = 0.0;
  for (std::size_t i = 0; i < tilt[0].size(); ++i)
    change = std::max(change, std::abs(tilt[0][i] - before[0][i]));
  EXPECT_LT(change, 2.0) << "degrees, where the tilt turns back in a corner";
}

TEST(Recorded, ExtremesKeepTheReachOfACurve) {
  std::vector<double> values;
  for (int i = 0; i <= 30'000; ++i)
    values.push_back(std::sin(0.37 * i) * i);
  values[7'000] = NAN;
  const std::vector<double> kept = extremes_of(values, 2400);
  ASSERT_EQ(kept.size(), 2401U);
  const std::size_t column = 25;  // values
  int gaps = 0;
  for (std::size_t i = 0; i < 1200; ++i) {
    const auto from = values.begin() + 1 + static_cast<long>(i * column);
    if (std::isnan(kept[1 + 2 * i])) {
      ++gaps;
      continue;
    }
    const auto [low, high] = std::minmax_element(from, from + column);
    EXPECT_EQ(std::min(kept[1 + 2 * i], kept[2 + 2 * i]), *low);
    EXPECT_EQ(std::max(kept[1 + 2 * i], kept[2 + 2 * i]), *high);
    EXPECT_EQ(kept[1 + 2 * i] == *low, low < high);
  }
  EXPECT_EQ(gaps, 1);
  // an angle that begins again everywhere is not left blank
  for (std::size_t i = 5; i < values.size(); i += 20)
    values[i] = NAN;
  for (const double value : extremes_of(values, 2400))
    EXPECT_FALSE(std::isnan(value));
  EXPECT_EQ(extremes_of({1.0, 2.0}, 2400), (std::vector<double>{1.0, 2.0}));
}

}  // namespace
}  // namespace polhode::test
