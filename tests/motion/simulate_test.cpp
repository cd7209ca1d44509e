// SPDX-License-Identifier: MIT
#include "motion/simulate.h"

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

MotionSpec spinning(double duration) {
  MotionSpec spec;
  spec.duration = duration;
  spec.spin.body = Vec3(1.0, 0.3, 3.0);
  return spec;
}

NumericsSpec by(const std::string& model, const std::string& method) {
  NumericsSpec numerics;
  numerics.model = model;
  numerics.method = method;
  return numerics;
}

double largest_difference(const Motion& a, const Motion& b) {
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = a.duration() * i / 1000;
    worst = worse(worst, rotation_angle_between(a.at(t).q_SB, b.at(t).q_SB));
  }
  return worst;
}

// a method that is no splitting integrates the equations of motion
TEST(ModelChoice, FollowsTheMethod) {
  const BodyModel heavy = heavy_body({0.6, 0.8, 1.0}, {0.3, 0.2, 0.1});
  EXPECT_EQ(simulate(heavy, spinning(1.0), by("auto", "rk4"), 1e-6).report.model, "ode");
  EXPECT_EQ(simulate(heavy, spinning(1.0), by("auto", "kick_srkn6"), 1e-6).report.model,
            "splitting");
  const SimulationReport ode = simulate(heavy, spinning(1.0), by("ode", "auto"), 1e-6).report;
  EXPECT_EQ(ode.method, "taylor10");
  expect_input_error([&] { simulate(heavy, spinning(1.0), by("splitting", "rk4"), 1e-6); },
                     "numerics.method",
                     "symplectic method");
}

TEST(ModelChoice, SaysWhy) {
  const BodyModel top = free_body({1, 1, 1.8});
  const SimulationReport exact = simulate(top, spinning(1.0), {}, 1e-6).report;
  EXPECT_EQ(exact.method, "exact");
  EXPECT_NE(exact.model_reason.find("symmetric oblate"), std::string::npos);
  EXPECT_FALSE(exact.step.has_value());
  EXPECT_LE(exact.record.drift.energy.value(), 1e-14);

  const SimulationReport asked = simulate(top, spinning(1.0), by("auto", "rk4"), 1e-6).report;
  EXPECT_EQ(asked.model, "ode");
  EXPECT_EQ(asked.method, "rk4");
  EXPECT_TRUE(asked.step.has_value());
  EXPECT_EQ(asked.accuracy_rad, 1e-6);
}

TEST(ModelErrors, NameTheKey) {
  const BodyModel asymmetric = heavy_body({0.6, 0.8, 1.0}, {0.3, 0.2, 0.1});
  const BodyModel top = free_body({1, 1, 1.8});
  const auto run = [](const BodyModel& model, const NumericsSpec& numerics) {
    return [&model, numerics] {
      simulate(model, spinning(1.0), numerics, 1e-6);
    };
  };
  expect_input_error(run(top, by("symetric", "auto")), "numerics.model", "symmetric");
  expect_input_error(run(top, by("spherical", "auto")), "numerics.model", "not equal");
  expect_input_error(run(asymmetric, by("symmetric", "auto")), "numerics.model", "gravity");
  expect_input_error(run(asymmetric, by("asymmetric", "auto")), "numerics.model", "gravity");
  expect_input_error(run(asymmetric, by("heavy_symmetric", "auto")), "numerics.model", "equal");
  expect_input_error(run(top, by("asymmetric", "auto")), "numerics.model", "two moments are equal");
  expect_input_error(run(top, by("heavy_symmetric", "auto")), "numerics.model", "no gravity");
  const BodyModel askew = heavy_body({1, 1, 1.8}, {0.1, 0, 0.4});
  expect_input_error(run(askew, by("heavy_symmetric", "auto")), "numerics.model", "not on the");
  expect_input_error(run(asymmetric, by("auto", "exact")), "numerics.method", "no closed form");
  expect_input_error(run(top, by("symmetric", "rk4")), "numerics.method", "takes no method");
  expect_input_error(run(top, by("ode", "rk44")), "numerics.method", "rk4");

  NumericsSpec stepped = by("ode", "dopri5");
  stepped.step = 0.01;
  expect_input_error(run(top, stepped), "numerics.step", "give a tolerance");
  NumericsSpec tolerant = by("ode", "rk4");
  tolerant.tolerance = 1e-6;
  expect_input_error(run(top, tolerant), "numerics.tolerance", "give a step");

  NumericsSpec tiny = by("ode", "rk4");
  tiny.step = 1e-12;
  expect_input_error(run(top, tiny), "numerics.step", "at most");
  expect_input_error([&] { simulate(top, spinning(100.0), by("ode", "explicit_euler"), 1e-9); },
                     "numerics.accuracy",
                     "allow more with numerics.max_steps");
  NumericsSpec few = by("ode", "rk4");
  few.step = 1e-3;
  few.max_steps = 999;
  expect_input_error(run(top, few), "numerics.step", "needs at least about 1e+03 steps for 1 s");
  few.max_steps = 1000;
  EXPECT_EQ(simulate(top, spinning(1.0), few, 1e-6).report.record.steps, 1000);
}

// the accuracy that a run claims, against the closed form of a symmetric top
struct Claim {
  const char* method;
  double accuracy;
};
void PrintTo(const Claim& claim, std::ostream* out) {
  *out << claim.method << claim.accuracy;
}
class Refinement : public testing::TestWithParam<Claim> {};
INSTANTIATE_TEST_SUITE_P(Methods,
                         Refinement,
                         testing::Values(Claim{"auto", 1e-3},
                                         Claim{"auto", 1e-6},
                                         Claim{"auto", 1e-9},
                                         Claim{"rk4", 1e-3},
                                         Claim{"rk4", 1e-8},
                                         Claim{"implicit_midpoint", 1e-3},
                                         Claim{"implicit_midpoint", 1e-4},
                                         Claim{"dop853", 1e-9},
                                         Claim{"gauss6", 1e-8},
                                         Claim{"dmv6", 1e-9},
                                         Claim{"rkmk4", 1e-6},
                                         Claim{"explicit_euler", 1e-2}),
                         [](const auto& claim) {
                           return fmt::format("{}_{}_digits",
                                              claim.param.method,
                                              std::lround(-std::log10(claim.param.accuracy)));
                         });

TEST_P(Refinement, MeetsTheAccuracyItClaims) {
  const auto [method, accuracy] = GetParam();
  for (const Vec3& moments : {Vec3(1, 1, 1.8), Vec3(1, 1, 0.2), Vec3(1.7, 1, 1)}) {
    const BodyModel top = free_body(moments);
    const Simulation exact = simulate(top, spinning(10.0), {}, accuracy);
    const Simulation found = simulate(top, spinning(10.0), by("ode", method), accuracy);
    const double error = largest_difference(found.motion, exact.motion);
    expect_residual(fmt::format("{} asked for {:g}", method, accuracy), error, accuracy);
    ASSERT_TRUE(found.report.error_estimate_rad.has_value());
    EXPECT_LE(*found.report.error_estimate_rad, accuracy);
    EXPECT_LE(error, 1.5 * *found.report.error_estimate_rad);
    // and not absurdly finer than asked for; a series of high order jumps
    if (find_stepper(found.report.method).order < 10) {
      EXPECT_GE(error, 1e-5 * accuracy);
    }
  }
}

// a method that cannot take the scene is refused with the reason and those that can
TEST(Simulate, RefusesAMethodThatCannotTakeTheScene) {
  const auto refused = [](const BodyModel& model, const char* method) {
    return [=] {
      simulate(model, spinning(1.0), by("ode", method), 1e-3);
    };
  };
  const BodyModel heavy = heavy_body({0.6, 0.8, 1.0}, {0.3, -0.5, 0.7});
  for (const char* words : {"takes free bodies only", "dop853", "taylor16", "list methods"})
    expect_input_error(refused(heavy, "dmv10"), "numerics.method", words);
  const auto rotating = [](const char* method) {
    MotionSpec spec;
    spec.duration = 1.0;
    spec.spin.body = Vec3(0.3, 1.2, 0.0);
    return simulate(free_body({1, 1, 0}), spec, by("ode", method), 1e-3);
  };
  expect_input_error([&] { rotating("dmv6"); }, "numerics.method", "all its mass on a line");
  EXPECT_EQ(rotating("kick_strang").report.method, "kick_strang");
}

TEST(Simulate, AnAskedForStepIsTaken) {
  NumericsSpec numerics = by("ode", "rk4");
  numerics.step = 0.01;
  const SimulationReport report =
      simulate(free_body({1, 1, 1.8}), spinning(1.0), numerics, 1e-6).report;
  EXPECT_EQ(report.record.steps, 100);
  EXPECT_EQ(report.step, 0.01);
  EXPECT_FALSE(report.error_estimate_rad.has_value());
}

TEST(ParseAccuracy, RadiansAndPixels) {
  EXPECT_EQ(parse_accuracy("0.1px").value, 0.1);
  EXPECT_TRUE(parse_accuracy("0.1px").pixels);
  EXPECT_EQ(parse_accuracy("1e-6").value, 1e-6);
  EXPECT_FALSE(parse_accuracy("1e-6").pixels);
  for (const char* wrong : {"", "px", "nan", "inf", "1 rad", "0.1pxx", "1e999"}) {
    expect_input_error([&] { parse_accuracy(wrong); }, "", "not an accuracy");
  }
  for (const char* wrong : {"0", "-1", "0px"}) {
    expect_input_error([&] { parse_accuracy(wrong); }, "", "greater than 0");
  }
}

TEST(Names, StartWithAutoAndCoverTheTables) {
  EXPECT_EQ(model_names().size(), solution_methods().size() + 1);
  EXPECT_EQ(model_names().front(), "auto");
  EXPECT_EQ(model_names().back(), "table_coulomb");
  EXPECT_EQ(method_names().size(), stepper_table().size() + 2);
  EXPECT_EQ(method_names().front(), "auto");
}

// a step longer than the motion, or a multiple of the period of a load, would agree with its half
TEST(Simulate, GivenStepsThatSeeNothingAreDoubted) {
  BodySpec heavy;
  heavy.moments = Vec3(1, 2, 3);
  heavy.mass = 1.0;
  heavy.center_of_mass = Vec3(0.1, 0.05, 0.2);
  MotionSpec falling;
  falling.hold = "pivot";
  falling.duration = 3.0;
  falling.spin.body = Vec3(1, 2, 3);
  BodySpec free;
  free.moments = Vec3(1, 2, 2.5);
  MotionSpec shaken;
  shaken.duration = 10.0;
  shaken.spin.body = Vec3(0.01, 0.02, 0.03);
  shaken.torque.resize(1);
  shaken.torque[0].kind = "constant";
  shaken.torque[0].body = Vec3(0.02, 0.01, 0);
  shaken.torque[0].rate = 20.0 * kPi;
  const auto is_doubted = [](const BodySpec& body, const MotionSpec& motion, double step) {
    NumericsSpec numerics;
    numerics.step = step;
    bool all = true;
    for (const char* method : {"rk4", "rk2", "explicit_euler"}) {
      numerics.method = method;
      const BodyModel model = make_model(body, motion);
      try {
        all = all && !simulate(model, motion, numerics, 1e-2).report.reliability.doubts.empty();
      } catch (const Error&) {
        // refused
      }
    }
    return all;
  };
  for (const double step : {6.0, 100.0})
    EXPECT_TRUE(is_doubted(heavy, falling, step)) << step;
  for (const double step : {0.4, 0.8})
    EXPECT_TRUE(is_doubted(free, shaken, step)) << step;
}

// a force through the centre of mass turns nothing, yet no step may leap over its periods
TEST(Simulate, FastForcesThroughTheCentreAreSeen) {
  BodySpec body;
  body.moments = Vec3(1, 2, 2.5);
  body.mass = 1.0;
  MotionSpec motion;
  motion.duration = 10.0;
  motion.position = Vec3(1, 0, 0);
  motion.torque.resize(2);
  motion.torque[0].kind = "spring";
  motion.torque[0].k = 0.04;
  motion.torque[1].kind = "force";
  motion.torque[1].space = Vec3(0, 0.5, 0);
  motion.torque[1].rate = 603.1857894892403;
  NumericsSpec numerics;
  numerics.method = "rk4";
  const BodyModel model = make_model(body, motion);
  const Simulation found = simulate(model, motion, numerics, 1e-3);
  EXPECT_LT(std::abs(found.motion.at(10.0).center_S.y()), 1e-3);
}

}  // namespace
}  // namespace polhode
