// SPDX-License-Identifier: MIT
#include "app/commands/inspect.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/json.h"
#include "scene/scene_file.h"
#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

Json facts_of(const std::string& text) {
  return inspection(solve(parse_scene(text, "scene.toml")));
}

Vec3 vector_of(const Json& list) {
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}

// a box: m (b^2 + c^2) / 12, here with its moments in falling order
TEST(Inspect, MomentsAscendAndTheirAxesAreRightHanded) {
  const Json facts = facts_of(
      "title = \"brick\"\n[body]\nsolid = { kind = \"box\", size = [0.1, 0.2, 0.3], mass = 2 }\n"
      "[motion]\nspin = { body = [0, 1, 0.1] }\n");
  EXPECT_EQ(facts.at("title"), "brick");
  EXPECT_EQ(facts.at("kind"), "asymmetric");
  EXPECT_EQ(facts.at("reference"), "center of mass");
  const Vec3 ascending = Vec3(0.04 + 0.01, 0.09 + 0.01, 0.09 + 0.04) * 2.0 / 12.0;
  EXPECT_LT((vector_of(facts.at("principal_moments_kg_m2")) - ascending).norm(), 1e-15);
  const Json& axes = facts.at("principal_axes");
  const Vec3 first = vector_of(axes.at(0)), second = vector_of(axes.at(1)),
             third = vector_of(axes.at(2));
  EXPECT_NEAR(std::abs(first.z()), 1.0, 1e-15);
  EXPECT_NEAR(std::abs(third.x()), 1.0, 1e-15);
  EXPECT_LT((first.cross(second) - third).norm(), 1e-15);
  EXPECT_NEAR(facts.at("tensor_kg_m2").at(0).at(0), ascending.z(), 1e-15);
  // y, z, x are right-handed as they are
  const Json cyclic = facts_of(
      "[body]\nsolid = { kind = \"box\", size = [0.1, 0.3, 0.2], mass = 2 }\n"
      "[motion]\nspin = { body = [0, 1, 0.1] }\n");
  const Json& turned = cyclic.at("principal_axes");
  EXPECT_LT(
      (vector_of(turned.at(0)).cross(vector_of(turned.at(1))) - vector_of(turned.at(2))).norm(),
      1e-15);
}

// a rod of length 0.4 m that hangs from its end: 2 pi sqrt(2 L / (3 g))
TEST(Inspect, OnAPivotTheFixedPointIsTheReference) {
  const Json facts = facts_of(
      "[body]\nsolid = { kind = \"rod\", length = 0.4, mass = 1, at = [0, 0, 0.2] "
      "}\n[motion]\nhold = "
      "\"pivot\"\nduration = 1\nattitude = { zxz_deg = [0, 170, 0] }\n");
  EXPECT_EQ(facts.at("reference"), "fixed point");
  EXPECT_NEAR(facts.at("principal_moments_kg_m2").at(2), 0.16 / 3.0, 1e-15);
  const double period = 2.0 * kPi * std::sqrt(2.0 * 0.4 / (3.0 * 9.80665));
  EXPECT_NEAR(facts.at("derived").at("small_oscillation_period_s"), period, 1e-12);
}

// what the equations of motion would have cost, or have
TEST(Inspect, EvaluationsAreThoseOfTheMethodAndOfTheEquations) {
  const Json closed = facts_of(test::kSmallScene);
  EXPECT_EQ(closed.at("method"), "exact");
  EXPECT_EQ(closed.at("evaluations"), 0);
  EXPECT_GT(closed.at("evaluations_of_ode"), 10);
  const Json integrated =
      facts_of(std::string(test::kSmallScene) + "[numerics]\nmethod = \"rk4\"\nstep = 0.1\n");
  EXPECT_EQ(integrated.at("evaluations"), 40) << "four in each of ten steps";
  EXPECT_EQ(integrated.at("evaluations_of_ode"), integrated.at("evaluations"));
}

// the words say what the JSON says, angles in degrees besides
TEST(Inspect, TextAndJsonAgree) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "scene.toml", test::kSmallScene);
  InspectJob job;
  job.scene = folder / "scene.toml";
  const std::string text = inspect(job);
  job.json = true;
  const Json facts = Json::parse(inspect(job));
  const auto line = [&](const std::string& key) {
    const std::size_t at = text.find(key + " ");
    EXPECT_NE(at, std::string::npos) << key;
    return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
  };
  EXPECT_NE(line("kind").find("  symmetric prolate"), std::string::npos);
  EXPECT_NE(line("principal_moments_kg_m2").find("0.004  0.01  0.01"), std::string::npos);
  EXPECT_NE(line("principal_axes").find("0  0  1; "), std::string::npos);
  const double rate = facts.at("derived").at("precession_rate_rad_per_s");
  EXPECT_NEAR(rate, std::hypot(1.0, 0.4 * 3.0), 1e-12) << "L / I1";
  EXPECT_NE(line("precession_rate_rad_per_s")
                .find(fmt::format("{:.6g}  ({:.6g} deg/s)", rate, rate * 180.0 / kPi)),
            std::string::npos);
  const double angle = facts.at("derived").at("axis_to_momentum_angle_rad");
  EXPECT_NEAR(angle, std::atan2(1.0, 1.2), 1e-12);
  EXPECT_NE(line("axis_to_momentum_angle_rad").find(fmt::format("({:.6g} deg)", angle * 180 / kPi)),
            std::string::npos);
}

TEST(Inspect, TakesTheOverridesOfTheCommandLine) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "scene.toml", test::kSmallScene);
  InspectJob job;
  job.scene = folder / "scene.toml";
  job.json = true;
  job.overrides.method = "dop853";
  EXPECT_EQ(Json::parse(inspect(job)).at("method"), "dop853");
}

// plots that each panel alone can have
TEST(Inspect, RefusesPlotsThatPanelsCannotHaveTogether) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "scene.toml", test::kSmallScene);
  InspectJob job;
  job.scene = folder / "film.toml";
  const auto with = [&](const std::string& values, const std::string& plots) {
    test::write_text(folder / "film.toml",
                     "[sweep]\nscene = \"scene.toml\"\nkey = \"motion.spin.body[0]\"\nvalues = " +
                         values + "\n[show]\nplots = " + plots + "\n");
  };
  with("[0.1, 0.2]", "[\"energy\"]");
  EXPECT_NE(inspect(job), "");
  with("[0.1, 0.2, 0.3]", "[\"energy\"]");
  test::expect_input_error([&] { inspect(job); }, "show.plots", "a plot holds 6 curves");
}

}  // namespace
}  // namespace polhode
