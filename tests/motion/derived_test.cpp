// SPDX-License-Identifier: MIT
// What theory says of a motion against what is measured on the motion itself.
#include "motion/derived.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "math/elliptic.h"
#include "math/so3.h"
#include "motion/simulate.h"
#include "support/motions.h"
#include "support/residual.h"
#include "support/tops.h"

namespace polhode {
namespace {

using test::expect_residual;

struct Case {
  Motion motion;
  std::vector<Quantity> numbers;

  double operator()(const std::string& key) const {
    const std::optional<double> value = value_of(numbers, key);
    EXPECT_TRUE(value.has_value()) << key;
    return value.value_or(std::nan(""));
  }
};

Case case_of(const BodySpec& body, const MotionSpec& spec) {
  const BodyModel model = make_model(body, spec);
  return {simulate(model, spec, {}, 1e-9).motion, derived_quantities(model, spec)};
}

// angle from a to b about the axis n
double turn_about(const Vec3& n, const Vec3& a, const Vec3& b) {
  return std::atan2(n.dot(a.cross(b)), a.dot(b) - a.dot(n) * b.dot(n));
}

TEST(Derived, FreeSymmetricTopPrecessesAndSpinsAsSaid) {
  for (const BodySpec& body : {test::prolate_body(), test::oblate_body()}) {
    const Case top = case_of(body, test::wobbling());
    const double t = 0.05;
    const Sample a = top.motion.at(0.0);
    const Sample b = top.motion.at(t);
    const Vec3 n = a.L_S.normalized();
    const Vec3 axis_a = a.q_SB * Vec3::UnitZ();
    const Vec3 axis_b = b.q_SB * Vec3::UnitZ();
    const double precession = turn_about(n, axis_a, axis_b) / t;
    expect_residual(
        "precession rate", std::abs(precession - top("precession_rate_rad_per_s")), 1e-13);
    // omega goes round in the body against the own spin
    const double euler = turn_about(Vec3::UnitZ(), a.w_B, b.w_B) / t;
    expect_residual("spin rate", std::abs(-euler - top("spin_rate_rad_per_s")), 1e-13);
    expect_residual(
        "space cone", std::abs(angle_between(b.w_S, n) - top("space_cone_half_angle_rad")), 1e-13);
    expect_residual("body cone",
                    std::abs(angle_between(b.w_S, axis_b) - top("body_cone_half_angle_rad")),
                    1e-15);
  }
}

TEST(Derived, MiddleAxisTurnsOverAfterTheFlipTime) {
  BodySpec body;
  body.moments = Vec3(1.0, 1.5, 2.2);
  MotionSpec spec;
  spec.spin.body = Vec3(0.01, 3.0, 0.02);
  spec.duration = 40.0;
  const Case top = case_of(body, spec);

  // zeros of omega_2, by bisection
  std::vector<double> zeros;
  for (double t = 0.0; t < 39.9; t += 0.01) {
    double low = t, high = t + 0.01;
    const double sign = top.motion.at(low).w_B.y();
    if (sign * top.motion.at(high).w_B.y() > 0.0) continue;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (sign * top.motion.at(middle).w_B.y() > 0.0 ? low : high) = middle;
    }
    zeros.push_back(low);
  }
  ASSERT_GE(zeros.size(), 3u);
  expect_residual("flip time", std::abs(zeros[2] - zeros[1] - top("flip_time_s")), 5e-14);
  EXPECT_NEAR(top("polhode_period_s"), 2.0 * top("flip_time_s"), 1e-14);

  // on the separatrix, I1 (I2 - I1) w1^2 = I3 (I3 - I2) w3^2, a tiny tilt grows at the rate
  const double rate = top("growth_rate_off_middle_axis_per_s");
  MotionSpec tiny = spec;
  const double slope = -std::sqrt(1.0 * 0.5 / (2.2 * 0.7));
  tiny.spin.body = Vec3(1e-7, 3.0, 1e-7 * slope);
  const Motion grown = case_of(body, tiny).motion;
  const auto tilt = [&](double t) {
    return std::hypot(grown.at(t).w_B.x(), grown.at(t).w_B.z());
  };
  expect_residual("growth rate", std::abs(std::log(tilt(4.0) / tilt(3.0)) - rate), 2e-11);
}

// the rate of the Euler angle phi about L (Landau and Lifshitz, Mechanics, 37), summed over one
// period: the trapezoidal rule converges geometrically there
TEST(Derived, MeanPrecessionOfAsymmetricTops) {
  for (const bool long_axis : {true, false}) {
    BodySpec body;
    body.moments = Vec3(1.0, 1.5, 2.2);
    MotionSpec spec;
    spec.spin.body = long_axis ? Vec3(3.0, 0.9, 0.8) : Vec3(0.8, 0.9, 3.0);
    spec.duration = 100.0;
    const Case top = case_of(body, spec);
    EXPECT_EQ(top("spins_about_long_axis"), long_axis ? 1.0 : 0.0);
    const double period = top("polhode_period_s");
    const int axis = long_axis ? 0 : 2;
    double sum = 0.0;
    for (int i = 0; i < 200; ++i) {
      const Vec3 w = top.motion.at(period * i / 200).w_B;
      const Vec3 L = w.cwiseProduct(*body.moments);
      double energy = w.dot(L) - w[axis] * L[axis];
      sum += L.norm() * energy / (L.squaredNorm() - L[axis] * L[axis]) / 200;
    }
    expect_residual(
        "mean precession", std::abs(sum - top("mean_precession_rate_rad_per_s")), 1e-13);
  }
}

// strips, whose rate has peaks where the momentum passes the narrow side of its ellipse:
// quadratures in 50 digits
TEST(Derived, MeanPrecessionOfFlatStrips) {
  struct Strip {
    Vec3 size, spin;
    double mean;
  };
  for (const Strip& strip : {Strip{{1, 0.01, 0.001}, {0.6, 0, 6}, 11.92510},
                             Strip{{1, 0.03, 0.001}, {0.6, 0, 6}, 11.9783},
                             Strip{{0.3, 0.003, 0.0005}, {0.6, 0, 6}, 11.820},
                             Strip{{1, 0.002, 0.0002}, {0.6, 0, 6}, 11.925},
                             Strip{{1, 0.005, 0.0005}, {0.06, 0.06, 6}, 11.94}}) {
    const Vec3 square = strip.size.cwiseProduct(strip.size) / 12.0;
    BodySpec body;
    body.mass = 1.0;
    body.moments = Vec3::Constant(square.sum()) - square;
    MotionSpec spec;
    spec.spin.body = strip.spin;
    EXPECT_NEAR(case_of(body, spec)("mean_precession_rate_rad_per_s"), strip.mean, 6e-4);
  }
}

// a slow turn in orbit: energies of either kind are no difference of the other
TEST(Derived, EnergyOfASlowSpinInFastFlight) {
  BodySpec body;
  body.mass = 1.0;
  body.moments = Vec3(1, 1, 1) / 600.0;
  MotionSpec spec;
  spec.velocity = Vec3(7700, 0, 0);
  spec.spin.body = Vec3(0, 0, 1.1e-3);
  const double about = 0.5 / 600.0 * 1.1e-3 * 1.1e-3;
  const char* const key = "kinetic_energy_about_center_of_mass_J";
  EXPECT_NEAR(case_of(body, spec)(key), about, 1e-14 * about);
  // likewise far from a pivot
  BodySpec far = body;
  far.about = "center";
  far.pivot = Vec3(0, 0, 1e3);
  MotionSpec held;
  held.hold = "pivot";
  held.gravity = Vec3::Zero();
  held.spin.body = Vec3(1.1e-3, 0, 0);
  EXPECT_NEAR(case_of(far, held)(key), about, 1e-9 * about);
}

// about L at right angles to its axis, a nearly spherical top turns about that slowly
TEST(Derived, SlowSpinsAreNoRoundOff) {
  BodySpec body;
  body.mass = 1.0;
  body.moments = Vec3(1.0, 1.0, 1.0000000085);
  MotionSpec spec;
  spec.duration = 1e-6;
  spec.spin.body = 3.081e6 * Vec3(std::cos(6.8e-5), 0.0, -std::sin(6.8e-5));
  const double spin = 3.081e6 * std::sin(6.8e-5) * 8.5e-9;
  EXPECT_NEAR(case_of(body, spec)("spin_rate_rad_per_s"), -spin, 1e-7 * spin);
  spec.spin.body = Vec3(3.081e6, 0.0, 1e-12);
  EXPECT_EQ(case_of(body, spec)("spin_rate_rad_per_s"), 0.0);
}

TEST(Derived, SteadyPrecessionIsSteady) {
  const BodySpec body = test::cone_body();
  MotionSpec spec = test::spinning_on_pivot();
  const double tilt = 0.5;
  const double w3 = 400.0;
  spec.spin = {};
  spec.spin.body = Vec3(0, 0, w3);
  const Case rest = case_of(body, spec);
  for (const char* key : {"slow_steady_precession_rad_per_s", "fast_steady_precession_rad_per_s"}) {
    const double rate = rest(key);
    spec.spin = {};
    spec.spin.rates = Vec3(rate, 0.0, w3 - rate * std::cos(tilt));
    spec.duration = 0.2;
    const Motion motion = case_of(body, spec).motion;
    for (const double t : {0.05, 0.2}) {
      const Vec3 axis = motion.at(t).q_SB * Vec3::UnitZ();
      expect_residual(key, std::abs(angle_between(axis, Vec3::UnitZ()) - tilt), 1e-14);
      const Vec3 start = motion.at(0.0).q_SB * Vec3::UnitZ();
      const double turned = turn_about(Vec3::UnitZ(), start, axis);
      expect_residual(key, std::abs(std::remainder(turned - rate * t, 2.0 * kPi)), 5e-14);
    }
  }
}

TEST(Derived, SleepingTopFallsAtItsRateBelowTheThreshold) {
  // A = 1, C = 0.5, mu = 1: w* = 4
  BodySpec body;
  body.moments = Vec3(1, 1, 0.5);
  body.about = "pivot";
  body.mass = 0.5;
  body.center_of_mass = Vec3(0, 0, 1);
  MotionSpec spec;
  spec.hold = "pivot";
  spec.gravity = Vec3(0, 0, -2.0);
  spec.attitude.zxz = Vec3(0, 1e-7, 0);
  spec.duration = 12.0;
  spec.spin.body = Vec3(0, 0, 4.2);
  const Case stable = case_of(body, spec);
  EXPECT_EQ(stable("sleeping_top_stable"), 1.0);
  EXPECT_NEAR(stable("sleeping_top_stability_ratio"), 1.1025, 1e-14);

  spec.spin.body = Vec3(0, 0, 2.0);
  const Case falling = case_of(body, spec);
  EXPECT_EQ(falling("sleeping_top_stable"), 0.0);
  EXPECT_NEAR(falling("sleeping_top_growth_rate_per_s"), std::sqrt(0.75), 1e-14);
  const auto tilt = [&](double t) {
    return angle_between(falling.motion.at(t).q_SB * Vec3::UnitZ(), Vec3::UnitZ());
  };
  expect_residual(
      "growth of the tilt", std::abs(std::log(tilt(11.0) / tilt(10.0)) - std::sqrt(0.75)), 2e-7);
}

TEST(Derived, PendulumAndEnergies) {
  BodySpec body;
  body.points = {{0.5, {0, 0, -1.2}}, {0.1, {0, 0, -0.6}}};
  MotionSpec spec;
  spec.hold = "pivot";
  spec.attitude.zxz = Vec3(0, 1e-4, 0);
  spec.duration = 5.0;
  const Case small = case_of(body, spec);
  const double period = small("small_oscillation_period_s");
  expect_residual("small oscillation",
                  (small.motion.at(period).center_S - small.motion.at(0).center_S).norm(),
                  1e-13);

  // a spin that is round-off is none
  spec.attitude.zxz = Vec3(0.3, 1e-4, 0);
  spec.spin.space = Vec3(std::cos(0.3), std::sin(0.3), 0) * 1e-3;
  EXPECT_NEAR(case_of(body, spec)("small_oscillation_period_s"), period, 1e-12 * period);
  spec.attitude.zxz = Vec3(0, 1e-4, 0);

  // the split of the energy, against sums over the two masses
  spec.spin.space = Vec3(0.7, 0, 0);
  const Case swung = case_of(body, spec);
  const Sample s = swung.motion.at(0.0);
  double kinetic = 0.0;
  for (const PointSpec& point : body.points)
    kinetic += 0.5 * point.m * point_velocity(swung.motion.model(), s, point.at).squaredNorm();
  EXPECT_NEAR(swung("kinetic_energy_J"), kinetic, 1e-15);
  const Vec3 v = point_velocity(swung.motion.model(), s, swung.motion.model().body.center);
  EXPECT_NEAR(swung("kinetic_energy_of_center_of_mass_J"), 0.3 * v.squaredNorm(), 1e-15);
  EXPECT_NEAR(swung("total_energy_J"), s.energy, 1e-14);
}

// the rings have energy of their own
TEST(Derived, EnergiesOfABodyInGimbals) {
  BodySpec body;
  body.moments = Vec3(0.02, 0.02, 0.03);
  MotionSpec spec;
  spec.hold = "pivot";
  spec.attitude.zxz = Vec3(0.1, 0.7, 0.0);
  spec.spin.rates = Vec3(2.0, 3.0, 5.0);
  spec.gimbals = GimbalsSpec{0.5, Vec3(0.2, 0.3, 0.25), Vec3::Zero(), {}};
  const Case found = case_of(body, spec);
  const double up = std::sin(0.7) * std::sin(0.7) * 0.3 + std::cos(0.7) * std::cos(0.7) * 0.25;
  const double rings = 0.5 * (0.2 * 9.0 + (0.5 + up) * 4.0);
  EXPECT_NEAR(found("kinetic_energy_of_gimbals_J"), rings, 1e-14);
  EXPECT_NEAR(found("kinetic_energy_J"),
              found("kinetic_energy_of_center_of_mass_J") +
                  found("kinetic_energy_about_center_of_mass_J") + rings,
              1e-14);
}

// PHYSICS: a published top (Hairer, Lubich, Wanner, VII.5.3), its numbers by two methods
TEST(Derived, NutationOfAPublishedTop) {
  BodySpec body;
  body.moments = Vec3(0.5, 0.5, 1.0);
  body.mathematical = true;
  body.about = "pivot";
  body.center_of_mass = Vec3(0, 0, 1);
  MotionSpec spec;
  spec.hold = "pivot";
  spec.gravity = Vec3(0, 0, -1);
  spec.attitude.quaternion = Eigen::Vector4d(0.4, 0.2, 0.4, 0.8);
  spec.spin.momentum_body = Vec3(0.2, 1.0, 0.4);
  const Case top = case_of(body, spec);
  const auto close = [&](const char* key, double wanted, double tolerance) {
    expect_residual(key, std::abs(top(key) - wanted), tolerance);
  };
  close("nutation_period_s", 2.49679814564629, 2e-14);
  close("precession_angle_per_nutation_rad", 6.12727820661848, 2e-13);
  close("least_tilt_rad", 51.64590115 * kPi / 180.0, 1e-9);
  close("greatest_tilt_rad", 121.8203569 * kPi / 180.0, 1e-9);
}

// the shape of the nutation, against the path of the axis itself
TEST(Derived, NutationLoopsCuspsAndWaves) {
  const struct {
    double precession;  // at the least tilt, of the slow steady rate
    double reverses;
  } cases[] = {{-1.0, 1.0}, {0.0, 0.0}, {0.5, 0.0}};
  for (const auto& one : cases) {
    SCOPED_TRACE(one.precession);
    MotionSpec spec = test::spinning_on_pivot();
    spec.spin = {};
    spec.spin.body = Vec3(0, 0, 300.0);
    const double rate =
        one.precession * case_of(test::cone_body(), spec)("slow_steady_precession_rad_per_s");
    spec.spin = {};
    spec.spin.rates = Vec3(rate, 0.0, 300.0 - rate * std::cos(0.5));
    const Case top = case_of(test::cone_body(), spec);
    const double period = top("nutation_period_s");
    EXPECT_NEAR(top("least_tilt_rad"), 0.5, 1e-13);
    EXPECT_NEAR(top("precession_rate_at_least_tilt_rad_per_s"), rate, 1e-10);
    EXPECT_EQ(top("precession_reverses"), one.reverses);

    // half a period later the axis is lowest; a whole one later it has gone round by what was said
    const auto axis = [&](double t) {
      return Vec3(top.motion.at(t).q_SB * Vec3::UnitZ());
    };
    EXPECT_NEAR(angle_between(axis(0.5 * period), Vec3::UnitZ()), top("greatest_tilt_rad"), 1e-12);
    EXPECT_NEAR(angle_between(axis(period), Vec3::UnitZ()), 0.5, 1e-12);
    const double turn = turn_about(Vec3::UnitZ(), axis(0.0), axis(period));
    const double said = top("mean_precession_rate_rad_per_s") * period;
    EXPECT_NEAR(std::remainder(turn - said, 2.0 * kPi), 0.0, 1e-12);
  }
}

// Its mean precession is m g l / L3, and that at the greatest tilt twice as fast, however little it
// turns in one nutation; released at rest it has a cusp.
TEST(Derived, VeryFastTopsHardlyPrecess) {
  BodySpec body;
  body.moments = Vec3(2, 2, 1);
  body.mass = 1.0;
  body.center_of_mass = Vec3(0, 0, 1);
  MotionSpec spec;
  spec.hold = "pivot";
  spec.duration = 1e-3;
  for (const double tilt : {0.5, 1.1, 2.3}) {
    spec.attitude.zxz = Vec3(0, tilt, 0.7);
    for (const double fast : {1e6, 1e7, 1e8, 1e9}) {
      SCOPED_TRACE(fast);
      spec.spin.body = Vec3(0, 0, fast);
      const Case top = case_of(body, spec);
      const double mean = 9.80665 / fast;
      expect_residual("mean", std::abs(top("mean_precession_rate_rad_per_s") / mean - 1.0), 1e-10);
      expect_residual(
          "lowest",
          std::abs(top("precession_rate_at_greatest_tilt_rad_per_s") / (2.0 * mean) - 1.0),
          1e-10);
      EXPECT_EQ(top("precession_rate_at_least_tilt_rad_per_s"), 0.0);
      EXPECT_EQ(top("precession_reverses"), 0.0);
    }
  }
  // beside the vertical the slow one of two circles is the larger
  for (const double tilt : {2e-6, 1e-5, kPi - 2e-6}) {
    spec.attitude.zxz = Vec3(0, tilt, 0);
    spec.spin.body = Vec3(0, 0, 1e4);
    const Case top = case_of(body, spec);
    const double slow = top("slow_steady_precession_rad_per_s");
    expect_residual("mean", std::abs(top("mean_precession_rate_rad_per_s") / slow - 1.0), 1e-6);
  }
  // of solids, the momentum across the axis is round-off at rest
  spec.attitude = {};
  for (int tilt = 5; tilt < 175; tilt += 3) {
    spec.attitude.tilt = tilt * kPi / 180.0;
    spec.spin.body = Vec3(0, 0, 3e4);
    EXPECT_EQ(case_of(test::cone_body(), spec)("precession_reverses"), 0.0) << tilt;
  }
}

// Of fast tops that sway far more than they precess: elliptic integrals in 70 digits, averaging
// (m g l L3 / L^2) and the azimuth of L in simulations.
TEST(Derived, FastTopsThatPassTheVertical) {
  BodySpec body;
  body.moments = Vec3(1e-5, 1e-5, 1.5e-5);
  body.mass = 0.1;
  body.about = "pivot";
  MotionSpec spec;
  spec.hold = "pivot";
  spec.duration = 1e-3;
  const auto told = [&](double height, double tilt, double sway) {
    body.center_of_mass = Vec3(0, 0, height);
    spec.attitude.zxz = Vec3(0, tilt, 0);
    spec.spin.body = Vec3(0, -sway, 5000);
    return value_of(derived_quantities(make_model(body, spec), spec),
                    "mean_precession_rate_rad_per_s");
  };
  for (const double tilt : {1e-6, 2e-6, 1e-5, 1e-3, 0.3})
    EXPECT_NEAR(told(1e-6, tilt, 3000).value_or(NAN), 1.127201e-5, 5e-11) << tilt;
  // what is left of a turn by either side is round-off: not told
  EXPECT_FALSE(told(1e-12, 0.3, 3000));
}

// the planar pendulum: T = 4 K(sin^2(amplitude / 2)) sqrt(A / mu), and beyond the top
TEST(Derived, SwingsAndRevolutionsOfAPendulum) {
  BodySpec body;
  body.points = {{0.5, {0, 0, -1.2}}, {0.1, {0, 0, -0.6}}};
  MotionSpec spec;
  spec.hold = "pivot";
  for (const double amplitude : {0.3, 1.5, 3.0}) {
    spec.attitude.zxz = Vec3(0, amplitude, 0);
    const Case pendulum = case_of(body, spec);
    const BodyModel& model = pendulum.motion.model();
    const double period = 4.0 * elliptic_k(std::pow(std::cos(0.5 * amplitude), 2)) *
                          std::sqrt(model.moments[0] / model.chi_P.norm());
    expect_residual("swing", std::abs(pendulum("swing_period_s") / period - 1.0), 1e-13);
    EXPECT_FALSE(value_of(pendulum.numbers, "mean_precession_rate_rad_per_s").has_value());
  }
  // let go less than a microradian from upright, it swings back
  spec.attitude.zxz = Vec3(0, kPi - 1e-7, 0);
  const Case almost = case_of(body, spec);
  EXPECT_NEAR(almost("swing_period_s"), 2.0 * almost("nutation_period_s"), 1e-9);
  EXPECT_FALSE(value_of(almost.numbers, "revolution_period_s").has_value());
  spec.attitude.zxz = Vec3(0, 0.4, 0);
  spec.spin.space = Vec3(9.0, 0, 0);
  const Case over = case_of(body, spec);
  const double period = over("revolution_period_s");
  // whatever the start, the axis comes to hang straight down
  for (const double tilt : {0.3491, 1.5795, 2.5307, 2.9670}) {
    spec.attitude.zxz = Vec3(0, tilt, 0);
    EXPECT_EQ(case_of(body, spec)("greatest_tilt_rad"), kPi) << tilt;
  }
  expect_residual(
      "revolution", (over.motion.at(period).center_S - over.motion.at(0).center_S).norm(), 1e-12);
  EXPECT_GT((over.motion.at(0.5 * period).center_S - over.motion.at(0).center_S).norm(), 1.0);
}

// however often the body turns in a period, its axis goes round L at about L / I
TEST(Derived, NearlySphericalBodiesPrecessFast) {
  for (const double difference : {1e-2, 1e-4, 1e-6}) {
    BodySpec body;
    body.moments = Vec3(1.0, 1.0 + difference, 1.0 + 2.0 * difference);
    MotionSpec spec;
    spec.spin.body = Vec3(1.0, 0.2, 3.0);
    const BodyModel model = make_model(body, spec);
    for (const Quantity& quantity : derived_quantities(model, spec)) {
      if (quantity.name != "mean_precession_rate") continue;
      EXPECT_NEAR(quantity.value, spec.spin.body->norm(), 4.0 * difference) << difference;
    }
  }
}

}  // namespace
}  // namespace polhode
