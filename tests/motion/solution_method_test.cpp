// SPDX-License-Identifier: MIT
#include "motion/solution_method.h"

#include <set>

#include <gtest/gtest.h>

#include "motion/motion.h"
#include "motion/stepper.h"
#include "motion/stepper_table.h"
#include "support/expect_error.h"
#include "support/loads.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

NumericsSpec by(const std::string& model, const std::string& method = "auto") {
  NumericsSpec numerics;
  numerics.model = model;
  numerics.method = method;
  return numerics;
}

BodyModel loaded(const LoadSpec& spec, const Vec3& moments = {1, 1.3, 1.6}) {
  MotionSpec motion = spun({1, 0, 0});
  motion.torque = {spec};
  return make_model(body_with(moments), motion);
}

BodyModel on_spring() {
  LoadSpec spring = load("spring");
  spring.k = 8.0;
  return loaded(spring);
}

TEST(SolutionMethod, TakesTheLeastThatAnswers) {
  const auto chosen = [](const BodyModel& model) {
    std::string reason;
    return choose_solution_method(model, {}, 1e-6, reason).name;
  };
  EXPECT_EQ(chosen(free_body({1, 1, 1})), "spherical");
  EXPECT_EQ(chosen(free_body({1, 1, 1.8})), "symmetric");
  EXPECT_EQ(chosen(free_body({0.6, 0.8, 1.0})), "asymmetric");
  EXPECT_EQ(chosen(heavy_body({1, 1, 1.8}, {0, 0, -0.4})), "heavy_symmetric");
  EXPECT_EQ(chosen(heavy_body({1, 1.8, 1}, {0, 0.4, 0})), "heavy_symmetric");
  EXPECT_EQ(chosen(heavy_body({1, 1, 1}, {0.3, 0.2, 0.1})), "heavy_symmetric");
  // the centre of mass off the axis, and no symmetry at all: no splitting is as cheap
  EXPECT_EQ(chosen(heavy_body({1, 1, 1.8}, {0.1, 0, 0.4})), "ode");
  EXPECT_EQ(chosen(heavy_body({0.6, 0.8, 1.0}, {0.3, 0.2, 0.1})), "ode");
  // a balanced body on a pivot is free
  EXPECT_EQ(chosen(heavy_body({0.6, 0.8, 1.0}, {0, 0, 0})), "asymmetric");
}

// every model answers for the body that it is for, and the reason is a phrase about that body
TEST(SolutionMethod, SaysWhy) {
  const auto reason = [](const BodyModel& model, const NumericsSpec& numerics = {}) {
    std::string text;
    choose_solution_method(model, numerics, 1e-6, text);
    return text;
  };
  EXPECT_EQ(reason(free_body({1, 1, 1.8})), "symmetric oblate body without torque: closed form");
  EXPECT_EQ(reason(heavy_body({1, 1, 1}, {0.3, 0.2, 0.1})),
            "spherical body with gravity on a pivot: closed form");
  LoadSpec damping = load("damping");
  damping.c = 0.3;
  EXPECT_EQ(reason(loaded(damping)),
            "asymmetric body with damping -c L: closed form in rescaled time");
  LoadSpec torque = load("constant");
  torque.body = Vec3(0, 0, 0.1);
  EXPECT_EQ(reason(loaded(torque)),
            "no closed form in this version for an asymmetric body with torques");
  EXPECT_NE(reason(on_spring()).find("depends on where the body is"), std::string::npos);
  EXPECT_EQ(reason(free_body({1, 1, 1}), by("ode")), "asked for");
  EXPECT_EQ(reason(free_body({1, 1, 1}), by("auto", "rk4")),
            "method rk4 integrates the equations of motion");
}

TEST(SolutionMethod, AMethodOfSteppingRulesOutClosedForms) {
  const auto chosen = [](const BodyModel& model, const std::string& method) {
    std::string reason;
    return choose_solution_method(model, by("auto", method), 1e-6, reason).name;
  };
  EXPECT_EQ(chosen(free_body({1, 1, 1.8}), "exact"), "symmetric");
  EXPECT_EQ(chosen(free_body({1, 1, 1.8}), "rk4"), "ode");
  EXPECT_EQ(chosen(heavy_asymmetric().model, "rk4"), "ode");
  EXPECT_EQ(chosen(heavy_asymmetric().model, "kick_strang"), "splitting");
  EXPECT_EQ(chosen(on_spring(), "rk4"), "ode6");
}

TEST(SolutionMethod, RefusesWhatCannotTakeTheScene) {
  const auto refused = [](const BodyModel& model, const NumericsSpec& numerics) {
    return [=] {
      std::string reason;
      choose_solution_method(model, numerics, 1e-6, reason);
    };
  };
  const BodyModel top = free_body({1, 1, 1.8});
  expect_input_error(refused(top, by("symetric")), "numerics.model", "did you mean 'symmetric'?");
  expect_input_error(refused(top, by("asymmetric")),
                     "numerics.model",
                     "model 'asymmetric' cannot take this scene: two moments are equal");
  expect_input_error(refused(top, by("splitting")), "numerics.model", "no gravity turns the body");
  expect_input_error(refused(on_spring(), by("ode")), "numerics.model", "where the body is");
  expect_input_error(
      refused(heavy_asymmetric().model, by("ode6")), "numerics.model", "a fixed point");
  expect_input_error(refused(heavy_asymmetric().model, by("splitting", "rk4")),
                     "numerics.method",
                     "needs a symplectic method, and rk4 is not");
}

// the table: the closed forms make trajectories that start with the start, the others make none
TEST(SolutionMethod, ClosedFormsStartWithTheStart) {
  const std::pair<std::string, BodyModel> bodies[] = {
      {"spherical", free_body({1, 1, 1})},
      {"symmetric", free_body({1, 1, 1.8})},
      {"asymmetric", free_body({0.6, 0.8, 1.0})},
      {"heavy_symmetric", heavy_body({1, 1, 1.8}, {0, 0, -0.4})}};
  const State start{exp_rotation({0.4, 1.1, -0.3}), {1.0, 0.4, -0.9}};
  std::set<std::string> made;
  for (const SolutionMethod& row : solution_methods()) {
    EXPECT_EQ(row.make != nullptr, row.closed_form) << row.name;
    EXPECT_FALSE(row.doc.empty()) << row.name;
    for (const auto& [name, model] : bodies) {
      if (!row.closed_form) continue;
      EXPECT_EQ(row.why_not(model).empty(), row.name == name) << row.name << " of " << name;
      if (row.name != name) continue;
      EXPECT_LE(distance(row.make(model, start)->at(0.0), start), 2e-15) << name;
      made.insert(name);
    }
  }
  EXPECT_EQ(made.size(), std::size(bodies));
}

TEST(WithNeededDegrees, AreSixWhereForcesDependOnThePlace) {
  EXPECT_FALSE(with_needed_degrees(free_body({1, 2, 2.5})).with_translation);
  EXPECT_FALSE(with_needed_degrees(heavy_asymmetric().model).with_translation);
  EXPECT_TRUE(with_needed_degrees(on_spring()).with_translation);
}

}  // namespace
}  // namespace polhode::test
