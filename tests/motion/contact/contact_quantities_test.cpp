// SPDX-License-Identifier: MIT
// Thresholds of theory against motions on either side of them.
#include "motion/contact/contact_quantities.h"

#include <cmath>

#include <gtest/gtest.h>

#include "math/so3.h"
#include "motion/derived.h"
#include "support/on_table.h"

namespace polhode::test {
namespace {

double quantity(const BodySpec& body, const MotionSpec& spec, const std::string& key) {
  const std::optional<double> found =
      value_of(derived_quantities(make_model(body, spec), spec), key);
  EXPECT_TRUE(found) << key;
  return found.value_or(NAN);
}

bool tells(const BodySpec& body, const MotionSpec& spec, const std::string& key) {
  return value_of(derived_quantities(make_model(body, spec), spec), key).has_value();
}

double tilt_at(const Integration& found, double t) {
  return angle_between(found.trajectory->at(t).q * Vec3::UnitZ(), Vec3::UnitZ());
}

MotionSpec spinning_top(double spin, double tilt, double seconds) {
  MotionSpec spec = on_table(seconds, viscous(2.0));
  spec.attitude.tilt = tilt;
  spec.spin.body = Vec3(0, 0, spin);
  return spec;
}

// it turns over, and the spin falls as Jellett's constant says
TEST(TippeTop, TurnsOver) {
  const BodySpec top = tippe_top_body(0.2, 1.08);
  const MotionSpec spec = spinning_top(160, 0.05, 12.0);
  const Integration found = integrated(top, spec, 1e-9);
  EXPECT_GT(tilt_at(found, 12.0), 3.05);
  const BodyModel model = make_model(top, spec);
  const double spin = angular_velocity(model, found.trajectory->at(12.0).y).z();
  // the spin that Jellett's constant of this start leaves: it leans by 0.05 rad
  const double told = quantity(top, spec, "spin_after_inversion_rad_per_s");
  EXPECT_NEAR(told, 160.0 * (std::cos(0.05) - 0.2) / 1.2, 1e-9);
  EXPECT_NEAR(-spin, told, 0.005 * 107);
}

TEST(TippeTop, DoesNotWhereInertiaForbidsIt) {
  for (const auto& [ratio, turns] : {std::pair{0.75, 0.0}, {1.08, 1.0}, {1.25, 0.0}}) {
    const BodySpec top = tippe_top_body(0.2, ratio);
    const MotionSpec spec = spinning_top(160, 0.05, 12.0);
    EXPECT_EQ(quantity(top, spec, "tippe_top_condition"), turns) << ratio;
    EXPECT_EQ(tells(top, spec, "upright_spin_for_inversion_rad_per_s"), turns == 1.0) << ratio;
    const Integration found = integrated(top, spec, 1e-8);
    EXPECT_EQ(tilt_at(found, 12.0) > 3.0, turns == 1.0) << ratio;
  }
  // and on ice
  MotionSpec ice = spinning_top(160, 0.05, 12.0);
  ice.friction.reset();
  EXPECT_LT(tilt_at(integrated(tippe_top_body(0.2, 1.08), ice, 1e-9), 12.0), 0.06);
}

// Near the least inertia that inverts, the upright place is left only at a spin that is more than
// enough to stay inverted.
TEST(TippeTop, MustLeaveTheUprightPlaceFirst) {
  const BodySpec top = tippe_top_body(0.2, 0.82);
  const MotionSpec spec = spinning_top(160, 0.05, 1.0);
  const double before = quantity(top, spec, "upright_spin_for_inversion_rad_per_s");
  EXPECT_EQ(before, quantity(top, spec, "upright_spin_limit_rad_per_s"));
  EXPECT_GT(before, 1.5 * quantity(top, spec, "inverted_spin_limit_rad_per_s"));
}

// the eigenvalues of the general equations change sign at the spin that the energy at fixed lambda
// gives, from either side within 1e-3, and so does the motion
TEST(TippeTop, LeavesTheUprightPlaceAboveItsLimit) {
  const BodySpec top = tippe_top_body(0.2, 1.08);
  const double limit = quantity(top, spinning_top(160, 0.0, 1.0), "upright_spin_limit_rad_per_s");
  const BodyModel model = with_needed_degrees(make_model(top, spinning_top(160, 0.0, 1.0)));
  EXPECT_EQ(growth_rate_of_spin(model, Vec3::UnitZ(), 0.97 * limit), 0.0);
  EXPECT_GT(growth_rate_of_spin(model, Vec3::UnitZ(), 1.03 * limit), 0.0);
  const auto grows = [&](double part) {
    const Integration found = integrated(top, spinning_top(part * limit, 1e-3, 200.0), 1e-10);
    return tilt_at(found, 200.0) > tilt_at(found, 100.0);
  };
  EXPECT_FALSE(grows(0.999));
  EXPECT_TRUE(grows(1.001));
}

// small deviations grow at the rates of the eigenvalues, which differ for the two senses
TEST(Rattleback, HasTwoGrowthRates) {
  const BodySpec celt = rattleback_body(0.05);
  for (const double spin : {4.0, -4.0}) {
    MotionSpec spec = on_table(6.0, rolling());
    spec.spin.body = Vec3(1e-7, 1e-7, spin);
    const double rate = quantity(celt, spec, "growth_rate_of_vertical_spin_per_s");
    const Integration found = integrated(celt, spec, 1e-13);
    // the largest horizontal rate in a second each, where the faster mode has taken over
    const auto size = [&](double from) {
      double most = 0.0;
      for (int i = 0; i < 400; ++i)
        most = std::max(most, found.trajectory->at(from + 0.0025 * i).y.head<2>().norm());
      return most;
    };
    const double measured = std::log(size(5.0) / size(3.0)) / 2.0;
    EXPECT_NEAR(measured, rate, 0.1 * rate + 0.02) << spin;
  }
  // the spin of one sense reverses, that of the other does not
  for (const double sense : {1.0, -1.0}) {
    MotionSpec spec = on_table(8.0, rolling());
    spec.spin.body = Vec3(0.02, 0.02, 4.0 * sense);
    const Integration found = integrated(celt, spec, 1e-9);
    const double end = found.trajectory->at(8.0).y.z();
    EXPECT_EQ(end * sense < 0.0, sense < 0.0);
  }
}

// tilt as (t0 - t)^2 and precession as 1 / (t0 - t), fitted over two decades of the tilt
TEST(EulersDisc, SettlesByItsPowerLaws) {
  MotionSpec spec = on_table(30.0, rolling());
  spec.friction->rolling = 1e-4;
  spec.attitude.tilt = 0.1;
  const double rate = std::sqrt(4.0 * kG / 0.0375 / std::sin(0.1));
  spec.spin.rates = Vec3(rate, 0.0, -rate * std::cos(0.1));
  const double predicted = quantity(disc_body(), spec, "end_time_s");
  const Integration found = integrated(disc_body(), spec, 1e-9);
  ASSERT_FALSE(found.record.events.empty());
  EXPECT_EQ(found.record.events.back().event, "lies_flat");
  // it lies at 1e-8 rad, a part sqrt(1e-7) before the end
  const double end = found.record.events.back().t / (1.0 - std::sqrt(1e-8 / 0.1));
  EXPECT_NEAR(end, predicted, 0.02 * predicted);
  const auto tilt_before = [&](double before) {
    // the disc wobbles about the mean
    double sum = 0.0;
    for (int i = 0; i < 64; ++i)
      sum += tilt_at(found, end - before * (1.0 + 0.02 * (i - 31.5) / 64));
    return sum / 64;
  };
  const double power = std::log(tilt_before(0.9 * end) / tilt_before(0.09 * end)) / std::log(10.0);
  EXPECT_NEAR(power, 2.0, 0.03);
}

// Formulas of level tables, of bodies on them and of their friction are told of no others.
class Untold : public ::testing::Test {
 protected:
  static LoadSpec push() {
    LoadSpec torque;
    torque.kind = "force";
    torque.space = Vec3(0.3, 0.0, 0.0);
    return torque;
  }
};

TEST_F(Untold, SlidingTimesOfBallsThatDoMore) {
  MotionSpec sliding = on_table(1.0, coulomb(0.2));
  sliding.velocity = Vec3(1.0, 0.0, 0.0);
  const std::string key = "sliding_time_s";
  EXPECT_TRUE(tells(ball_body(), sliding, key));
  MotionSpec other = sliding;
  other.gravity = Vec3(2.0, 0.0, -9.5);
  EXPECT_FALSE(tells(ball_body(), other, key)) << "a slope";
  other = sliding;
  other.torque = {push()};
  EXPECT_FALSE(tells(ball_body(), other, key)) << "pushed";
  other = sliding;
  other.friction->rolling = 0.02;
  EXPECT_FALSE(tells(ball_body(), other, key)) << "resistance to rolling";
  other = sliding;
  other.position = Vec3(0.0, 0.0, 0.5);
  EXPECT_FALSE(tells(ball_body(), other, key)) << "it falls first";
}

TEST_F(Untold, NoTimeOfSlidingWhereTheBallRolls) {
  MotionSpec rolls = on_table(1.0, coulomb(0.2));
  rolls.attitude.tilt = 0.3;
  rolls.velocity = Vec3(0.7 * 0.028, 0.0, 0.0);
  rolls.spin.space = Vec3(0.0, 0.7, 3.0);
  EXPECT_EQ(quantity(ball_body(0.028), rolls, "sliding_time_s"), 0.0);
}

TEST_F(Untold, LimitsOfRollingWhereNothingRolls) {
  const auto tells_limit = [](const std::optional<FrictionSpec>& friction) {
    MotionSpec spec = on_table(1.0, friction);
    spec.attitude.tilt = 1.2;
    return tells(disc_body(), spec, "upright_rolling_limit_rad_per_s");
  };
  EXPECT_TRUE(tells_limit(rolling()));
  EXPECT_TRUE(tells_limit(coulomb(0.5)));
  EXPECT_FALSE(tells_limit(viscous(1.0)));
  EXPECT_FALSE(tells_limit({}));
  FrictionSpec bores = rolling();
  bores.boring = 0.01;  // small deviations do not overcome it
  EXPECT_FALSE(tells_limit(bores));
}

TEST_F(Untold, InversionsOfTopsThatCannotOrHave) {
  const std::string after = "spin_after_inversion_rad_per_s";
  const BodySpec top = tippe_top_body(0.2, 1.08);
  MotionSpec spec = spinning_top(160, 0.05, 1.0);
  EXPECT_TRUE(tells(top, spec, after));
  EXPECT_FALSE(tells(tippe_top_body(0.2, 0.75), spec, after)) << "its inertia forbids it";
  EXPECT_FALSE(tells(top, spinning_top(160, 3.1, 1.0), after)) << "it has";
  EXPECT_FALSE(tells(top, spinning_top(30, 0.05, 1.0), after)) << "it comes to rest half-way";
  EXPECT_FALSE(tells(top, spinning_top(10, 0.05, 1.0), after)) << "it stays upright";
  MotionSpec falls = spec;
  falls.position = Vec3(0.0, 0.0, 0.5);
  EXPECT_FALSE(tells(top, falls, after)) << "it falls first, and lands at another tilt";
  spec.friction = rolling();
  EXPECT_FALSE(tells(top, spec, after)) << "rolling takes no energy";
  EXPECT_FALSE(tells(top, spec, "tippe_top_condition"));
  spec.friction = coulomb(0.3);
  EXPECT_FALSE(tells(top, spec, "tippe_top_condition")) << "dry friction holds it where it is";
  spec.friction.reset();
  EXPECT_FALSE(tells(top, spec, "tippe_top_condition")) << "on ice";
}

TEST_F(Untold, WhatTurningTablesAndMomentsOfFrictionChange) {
  const char* growth = "growth_rate_of_vertical_spin_per_s";
  MotionSpec celt = on_table(1.0, rolling());
  celt.spin.body = Vec3(0.0, 0.0, 4.0);
  EXPECT_TRUE(tells(rattleback_body(), celt, growth));
  celt.friction->turntable = 2.0;
  EXPECT_FALSE(tells(rattleback_body(), celt, growth));
  celt.friction->turntable = 0.0;
  celt.friction->rolling = 1e-4;
  EXPECT_FALSE(tells(rattleback_body(), celt, growth)) << "it holds small deviations";
  celt.friction->rolling = 0.0;
  celt.friction->boring = 1e-4;
  EXPECT_FALSE(tells(rattleback_body(), celt, growth)) << "it ends the spin";
  MotionSpec top = spinning_top(160, 0.0, 1.0);
  EXPECT_TRUE(tells(tippe_top_body(), top, "spin_after_inversion_rad_per_s"));
  top.friction->boring = 3e-4;
  EXPECT_FALSE(tells(tippe_top_body(), top, "spin_after_inversion_rad_per_s"));
  MotionSpec disc = on_table(1.0, rolling());
  disc.friction->rolling = 1e-4;
  disc.attitude.tilt = 0.4;
  disc.spin.rates = Vec3(30.0, 0.0, 0.0);
  EXPECT_TRUE(tells(disc_body(), disc, "end_time_s"));
  MotionSpec steep = disc;
  steep.attitude.tilt = 0.7;
  EXPECT_FALSE(tells(disc_body(), steep, "end_time_s")) << "its centre leaves its rest";
  BodySpec light = disc_body();  // at its rim
  light.look = light.solid;
  light.solid.reset();
  light.mass = 0.4;
  const double mass_a2 = 0.4 * 0.0375 * 0.0375;
  for (const auto& [part, told] : {std::pair{0.1, false}, {0.3, true}, {1.2, false}}) {
    light.moments = part * mass_a2 * Vec3(1.0, 1.0, 2.0);
    EXPECT_EQ(tells(light, disc, "end_time_s"), told) << part;
  }
  // and where it is thick, or friction is strong
  light.moments = 0.3 * mass_a2 * Vec3(1.0, 1.0, 1.6);
  EXPECT_FALSE(tells(light, disc, "end_time_s"));
  MotionSpec flatter = disc;
  flatter.attitude.tilt = 0.25;
  EXPECT_TRUE(tells(light, flatter, "end_time_s"));
  light.moments = 0.3 * mass_a2 * Vec3(1.0, 1.0, 0.9);
  EXPECT_FALSE(tells(light, flatter, "end_time_s"));
  flatter.friction->rolling = 0.2 * 0.0375;
  EXPECT_FALSE(tells(disc_body(), flatter, "end_time_s"));
  // and where it slides before it rolls
  flatter.friction->kind = "coulomb";
  flatter.friction->rolling = 1e-4;
  flatter.friction->mu = 0.1;
  EXPECT_TRUE(tells(disc_body(), flatter, "end_time_s"));
  flatter.friction->mu = 1e-3;
  EXPECT_FALSE(tells(disc_body(), flatter, "end_time_s"));
  disc.friction->boring = 2e-4;
  EXPECT_FALSE(tells(disc_body(), disc, "end_time_s"));
}

// However weak the friction is, a spin that it makes unstable grows, slowly.
TEST(VerticalSpin, WeakFrictionHasTheSameLimit) {
  const BodySpec top = tippe_top_body(0.2, 1.08);
  const double upright = quantity(top, spinning_top(160, 0.0, 1.0), "upright_spin_limit_rad_per_s");
  for (const double c : {1.0, 1e-2, 1e-4}) {
    MotionSpec spec = spinning_top(1.4 * upright, 0.0, 1.0);
    spec.friction = viscous(c);
    EXPECT_GT(quantity(top, spec, "growth_rate_of_vertical_spin_per_s"), 0.0) << c;
    EXPECT_NEAR(quantity(top, spec, "vertical_spin_limit_rad_per_s"), upright, 2e-3 * upright) << c;
  }
}

// The slip that friction leaves falls as it grows, and so does the growth, until only its round-off
// were left.
TEST(VerticalSpin, StrongFrictionHidesItsGrowth) {
  BodySpec cone = round_body("cone", 0.03, 0.06);
  cone.solid->height = 0.04;
  MotionSpec spec = on_table(0.01, viscous(1.0));
  spec.spin.body = Vec3(0.0, 0.0, 200.0);
  const auto growth = [&](double c) {
    spec.friction = viscous(c);
    return value_of(derived_quantities(make_model(cone, spec), spec),
                    "growth_rate_of_vertical_spin_per_s");
  };
  const double usual = 1e3 * growth(1e3).value_or(NAN);
  EXPECT_NEAR(1e5 * growth(1e5).value_or(NAN), usual, 1e-3 * usual);
  EXPECT_FALSE(growth(1e7));
  EXPECT_FALSE(tells(cone, spec, "vertical_spin_limit_rad_per_s"));
}

// Strong friction and a fast spin: against the eigenvalues of the linearised equations in 40 digits
// and a nonlinear integration.
TEST(VerticalSpin, GrowsAsInFortyDigits) {
  BodySpec egg;
  egg.tensor = Mat3{{5.7422897433997036e-05, 2.288183341750216e-06, 0.0},
                    {2.288183341750216e-06, 6.241108075341452e-05, 0.0},
                    {0.0, 0.0, 5.404004535427708e-05}};
  egg.mass = 0.1;
  egg.look.emplace();
  egg.look->kind = "ellipsoid";
  egg.look->semi_axes = Vec3(0.05171650219131213, 0.06339755914565481, 0.051626020757347506);
  MotionSpec spec = on_table(1e-7, viscous(11137.63995074827));
  spec.gravity = Vec3(0.0, 0.0, -9.8);
  spec.spin.body = Vec3(0.0, 0.0, 3904.668645996549);
  EXPECT_NEAR(quantity(egg, spec, "growth_rate_of_vertical_spin_per_s"), 211.14, 0.01);
  EXPECT_NEAR(quantity(egg, spec, "growth_rate_of_vertical_spin_reversed_per_s"), 230.24, 0.01);
}

// A celt grows at any spin and in both directions, less and less in one of them.
TEST(VerticalSpin, ACeltHasNoLimit) {
  const BodySpec celt = rattleback_body();
  for (const double direction : {1.0, -1.0}) {
    MotionSpec spec = on_table(1.0, rolling());
    spec.spin.body = Vec3(0.0, 0.0, 60.0 * direction);
    const BodyModel model = make_model(celt, spec);
    EXPECT_FALSE(
        value_of(derived_quantities(model, spec), "vertical_spin_limit_rad_per_s").has_value());
    for (double fast = 5.0; fast < 1500.0; fast *= 1.1)
      EXPECT_GT(growth_rate_of_spin(model, Vec3::UnitZ(), fast * direction), 0.0) << fast;
  }
}

// An ellipsoid of mass `mass` with principal axes turned about z, its centre `up` above that of
// mass, upside down.
BodySpec turned_ellipsoid(const Mat3& tensor, double mass, const Vec3& semi_axes, double up) {
  BodySpec body;
  body.tensor = tensor;
  body.mass = mass;
  body.look = SolidSpec{};
  body.look->kind = "ellipsoid";
  body.look->semi_axes = semi_axes;
  body.look->at = Vec3(0, 0, up);
  return body;
}
MotionSpec upside_down(double spin, const std::optional<FrictionSpec>& friction) {
  MotionSpec spec = on_table(1.0, rolling());
  spec.friction = friction;
  spec.attitude.tilt = kPi;
  spec.spin.body = Vec3(0.0, 0.0, spin);
  return spec;
}

// growth that fades away with the spin has no limit where it falls below what is told
TEST(VerticalSpin, FadingGrowthHasNoLimit) {
  Mat3 tensor;
  tensor << 8.018e-4, 2.068e-5, 0.0, 2.068e-5, 5.074e-4, 0.0, 0.0, 0.0, 3.164e-4;
  const BodySpec body = turned_ellipsoid(tensor, 0.184, Vec3(0.0652, 0.06612, 0.09156), 0.018);
  const MotionSpec spec = upside_down(33.0, rolling());
  EXPECT_GT(quantity(body, spec, "growth_rate_of_vertical_spin_per_s"), 0.0);
  EXPECT_FALSE(
      value_of(derived_quantities(make_model(body, spec), spec), "vertical_spin_limit_rad_per_s"));
}

// a range of stable spins that is as narrow as one in seventy
TEST(VerticalSpin, NarrowRangesAreFound) {
  Mat3 tensor;
  tensor << 3.02211807260199e-05, 4.142492980126705e-06, 0.0, 4.142492980126705e-06,
      1.9868075651119517e-05, 0.0, 0.0, 0.0, 2.7226721030098552e-05;
  const BodySpec body =
      turned_ellipsoid(tensor,
                       0.10879027971005353,
                       Vec3(0.057841279348973734, 0.0579080102844164, 0.09048602923224229),
                       -0.01602962371999372);
  const auto growth = [&](double spin) {
    return quantity(body, upside_down(spin, {}), "growth_rate_of_vertical_spin_per_s");
  };
  EXPECT_GT(growth(-66.0), 6.0);
  EXPECT_EQ(growth(-66.45), 0.0);
  EXPECT_GT(growth(-67.4), 3.0);
  const double limit = quantity(body, upside_down(-58.5, {}), "vertical_spin_limit_rad_per_s");
  EXPECT_NEAR(limit, 66.35, 0.05);
}

// Growth changes at the limit.
TEST(VerticalSpin, GrowthChangesAtItsLimit) {
  const BodySpec top = tippe_top_body(0.2, 1.08);
  for (const double spin : {160.0, -160.0}) {
    const MotionSpec spec = spinning_top(spin, 0.0, 1.0);
    const BodyModel model = make_model(top, spec);
    const double limit = quantity(top, spec, "vertical_spin_limit_rad_per_s");
    const auto grows = [&](double fast) {
      return growth_rate_of_spin(model, Vec3::UnitZ(), std::copysign(fast, spin)) > 0.0;
    };
    EXPECT_FALSE(grows(0.999 * limit)) << spin;
    EXPECT_TRUE(grows(1.001 * limit)) << spin;
  }
}

}  // namespace

}  // namespace polhode::test
