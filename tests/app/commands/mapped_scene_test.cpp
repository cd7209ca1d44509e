// SPDX-License-Identifier: MIT
#include "app/commands/mapped_scene.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/logged.h"
#include "support/run.h"

namespace polhode {
namespace {

class SceneOfMaps : public ::testing::Test {
 protected:
  SceneOfMaps() {
    test::write_text(folder_ / "scene.toml", test::kSmallScene);
    job_.cells = "3x2";
    job_.turns = 2.0;
    job_.jobs = 1;
  }
  MappedScene place(const std::string& methods = "rk4") const {
    return make_place(folder_ / "scene.toml", job_, parse_methods(methods));
  }
  MappedScene prepared(const std::string& methods = "rk4") const {
    MappedScene made = place(methods);
    std::set<int> rows;
    for (int row = 0; row < made.y.cells; ++row)
      rows.insert(row);
    prepare_rows(made, job_, rows);
    return made;
  }
  void expect_refused(const char* option, const char* words) const {
    test::expect_input_error([&] { place(); }, option, words);
  }
  // the scene's own angular momentum and rate of the body's turning, of the ellipsoid's moments
  static constexpr double kI1 = 0.01, kI3 = 0.004;

  test::TemporaryFolder folder_;
  StabilityJob job_;
};

// a factor of ten to both sides of a tenth of a turn; spins a tenth to ten times the scene's
TEST_F(SceneOfMaps, AxesReachAFactorOfTenToBothSides) {
  const MappedScene made = place();
  EXPECT_EQ(made.x.key, "numerics.step");
  EXPECT_EQ(made.x.cells, 3);
  EXPECT_EQ(made.y.cells, 2);
  EXPECT_NEAR(made.x.to / made.x.from, 100.0, 1e-9);
  EXPECT_EQ(made.y.key, "spin");
  EXPECT_EQ(made.y.from, 0.1);
  EXPECT_EQ(made.y.to, 10.0);
  EXPECT_FALSE(made.setup_per_cell());
}

TEST_F(SceneOfMaps, AKeyOfTheSceneIsChangedAroundItsOwnNumber) {
  job_.x = "motion.spin.body[2]";
  job_.y = "motion.spin.body[1]";
  const MappedScene made = place();
  EXPECT_NEAR(made.x.from, 0.3, 1e-15);
  EXPECT_NEAR(made.x.to, 30.0, 1e-12);
  EXPECT_EQ(made.y.from, -1.0) << "around zero";
  EXPECT_EQ(made.y.to, 1.0);
  EXPECT_TRUE(made.setup_per_cell());
  job_.x = "motion.attitude.zxz_deg[1]";
  job_.settings = {parse_setting("motion.attitude.zxz_deg[1]=-3")};
  EXPECT_EQ(place().x.from, -6.0);
  EXPECT_EQ(place().x.to, 6.0);
}

// rings turn with the body that they carry, also where the attitude does not tell how
TEST_F(SceneOfMaps, AFactorOnTheSpinTurnsTheRingsToo) {
  test::write_text(folder_ / "scene.toml",
                   "[body]\nmoments = [1, 1, 1.5]\n[motion]\nhold = \"pivot\"\nduration = 1\n"
                   "attitude = { zxz = [0.3, 0, 0] }\nspin = { rates = [0.5, 1, 2] }\n"
                   "gimbals = { outer = 0.5, inner = [0.2, 0.3, 0.25] }\n");
  job_.y_range = "2:3";
  const MappedScene made = prepared();
  const State& start = made.setup(0, 0).problem->start;
  EXPECT_LT((start.rings.rates - 2.0 * Vec3(0.5, 1.0, 2.0)).norm(), 1e-12);
}

TEST_F(SceneOfMaps, RangesAreTwoNumbersThatRise) {
  job_.x_range = "0.01:0.5";
  EXPECT_EQ(place().x.from, 0.01);
  EXPECT_EQ(place().x.to, 0.5);
  for (const char* text : {"", "1", "a:b", "1:", ":2", "1:2:3", "1:inf", "1:2x"}) {
    SCOPED_TRACE(text);
    job_.x_range = text;
    expect_refused("--x-range", "is not a range");
  }
  job_.x_range = "3:1";
  expect_refused("--x-range", "must go up, got 3:1");
  job_.x_range = "-1:1";
  expect_refused("--x-range", "greater than 0");
  job_.x_range.reset();
  job_.y_range = "0:1";
  expect_refused("--y-range", "spin must be greater than 0");
}

TEST_F(SceneOfMaps, WrongAxesSizesAndBodiesAreRefused) {
  for (const char* cells : {"", "3", "3x", "1x4", "4x1", "3x4x5", "1025x4", "a"}) {
    SCOPED_TRACE(cells);
    job_.cells = cells;
    expect_refused("--cells", "is not the size of a map");
  }
  job_.cells = "1024x1024";
  EXPECT_EQ(place().y.cells, 1024);
  job_.cells = "3x2";
  job_.y = "motion.spin.body[9]";
  expect_refused("--y", "has no number at 'motion.spin.body[9]'; give --y-range A:B");
  job_.y = "motion.duration";
  expect_refused("--y motion.duration", "changes nothing: --turns says how long");
  job_.y = "spin";
  test::write_text(folder_ / "scene.toml", "[body]\nmoments = [1, 2, 2.5]\n");
  EXPECT_THROW(place(), Error) << "at rest nothing can fail";
}

// a hoop that rolls, on a table: cells of maps have steps, and what goes from event to event has
// none
constexpr const char* kRollingHoop = R"(format = 1
body.solid = { kind = "ring", radius = 0.1, mass = 0.2 }
[motion]
hold = "table"
friction = { kind = "rolling" }
attitude = { zxz_deg = [0, 80, 0] }
spin = { rates = [1, 0, 10] }
duration = 2
)";
TEST_F(SceneOfMaps, OnATableHasMethodsOfFixedStepsAlone) {
  test::write_text(folder_ / "scene.toml", kRollingHoop);
  const MappedScene made = place("");
  ASSERT_FALSE(made.methods.empty());
  for (const StepperInfo* method : made.methods)
    EXPECT_TRUE(method->only_table) << method->name;
  test::expect_input_error([&] { place("dop853"); },
                           "--methods",
                           "dop853 goes from event to event on a table, by a tolerance");
}

// it rolls in every cell: its velocity follows the factor on its spin
TEST_F(SceneOfMaps, AFactorOnTheSpinSetsTheVelocityOfARollingBody) {
  test::write_text(folder_ / "scene.toml", kRollingHoop);
  const MappedScene made = prepared("table_rk4");
  for (const StabilitySetup& setup : made.setups) {
    const BodyModel& model = setup.problem->model;
    const Moving start = moving_of(model, setup.problem->start);
    EXPECT_GT(start.velocity_S.norm(), 0.05);
    EXPECT_LT(slip_of(model, Touch{}, start).norm(), 1e-13);
  }
}

TEST_F(SceneOfMaps, HasTheMethodsThatCanTakeTheScene) {
  EXPECT_EQ(place("rk4,dmv2,rk2").methods.size(), 3U);
  std::string heavy = test::kSmallScene;
  heavy.replace(heavy.find("duration"), 0, "hold = \"pivot\"\n");
  heavy.replace(heavy.find("kind = \"ellipsoid\", semi_axes = [0.1, 0.1, 0.2]"),
                std::string("kind = \"ellipsoid\", semi_axes = [0.1, 0.1, 0.2]").size(),
                "kind = \"cone\", radius = 0.1, height = 0.2");
  test::write_text(folder_ / "scene.toml", heavy);
  // what was asked for is not left out in silence
  job_.methods = "rk4,dmv2,rk2";
  const std::string told = test::logged_by([&] { place(job_.methods); });
  EXPECT_NE(told.find("dmv2 is left out for "), std::string::npos) << told;
  job_.methods = "";
  MappedScene made;
  EXPECT_EQ(test::logged_by([&] { made = place("rk4,dmv2,rk2"); }), "");
  ASSERT_EQ(made.methods.size(), 2U);
  EXPECT_EQ(made.methods[1]->name, "rk2");
  const std::string file = folder_ / "scene.toml";
  try {
    place("dmv2");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("dmv2 cannot take"), std::string::npos);
  }
}

// a row of spins, each with the duration of as many turns
TEST_F(SceneOfMaps, ASetupIsTheSceneWithItsValues) {
  const MappedScene made = prepared();
  ASSERT_EQ(made.setups.size(), 2U) << "steps need no setup of their own";
  for (const auto& [row, factor] : {std::pair{0, 0.1}, {1, 10.0}}) {
    const State& start = made.setup(2, row).problem->start;
    EXPECT_LT((start.y - factor * Vec3(kI1 * 1.0, 0.0, kI3 * 3.0)).norm(), 1e-15) << row;
  }
  EXPECT_NEAR(made.setup(0, 0).problem->duration / made.setup(0, 1).problem->duration, 100.0, 1e-9);
}

TEST_F(SceneOfMaps, TwoKeysHaveASetupForEachCell) {
  job_.x = "motion.spin.body[2]";
  job_.y = "body.solid.semi_axes[0]";
  job_.y_range = "0.1:0.2";
  const MappedScene made = prepared();
  ASSERT_EQ(made.setups.size(), 6U);
  const StabilityProblem& last = *made.setup(2, 1).problem;
  EXPECT_NEAR(last.model.moments.y(), 0.2 * (0.04 + 0.04), 1e-12) << "semi-axes 0.2, 0.1, 0.2";
  EXPECT_NEAR(last.start.y.norm(), made.setup(2, 1).problem->start.y.norm(), 0.0);
  EXPECT_NEAR(made.setup(0, 0).problem->start.y.z(), kI3 * 0.3, 1e-12);
  EXPECT_NEAR(made.setup(2, 0).problem->start.y.z(), kI3 * 30.0, 1e-12);
}

// RK4 is unstable from h |Omega| = 2 sqrt 2 on, Omega = w3 (I1 - I3) / I1
TEST_F(SceneOfMaps, TheLimitIsWhereTheMethodEnds) {
  job_.x_range = "0.01:9";
  job_.y_range = "1:2";
  const MappedScene made = prepared("rk4,implicit_midpoint");
  ASSERT_EQ(made.methods.front()->name, std::string("rk4"));
  const std::vector<std::vector<LimitPoint>> curves = limit_curves(made, job_);
  ASSERT_EQ(curves.size(), 2U);
  const std::vector<LimitPoint>& curve = curves[0];
  ASSERT_EQ(curve.size(), 2U);
  for (const LimitPoint& point : curve)
    EXPECT_NEAR(point.x, std::sqrt(8.0) / (point.y * 3.0 * (kI1 - kI3) / kI1), 1e-6);
  EXPECT_EQ(curve[1].y, 2.0);
  EXPECT_TRUE(curves[1].empty());
  EXPECT_EQ(try_cell(made, find_stepper("rk4"), 0, 0, 0.1).outcome, RunOutcome::fine);
  EXPECT_NE(try_cell(made, find_stepper("rk4"), 2, 0, 0.1).outcome, RunOutcome::fine);
  job_.x = "motion.spin.body[2]";
  job_.x_range = "1:3";
  EXPECT_TRUE(limit_curves(prepared(), job_)[0].empty()) << "no axis has steps";
}

// a part of the work prepares what it needs, and one cell alone is what it is in the map
TEST_F(SceneOfMaps, RowsArePreparedOneByOne) {
  MappedScene made = place();
  prepare_rows(made, job_, {1});
  EXPECT_EQ(made.setup(0, 0).problem, nullptr);
  ASSERT_NE(made.setup(0, 1).problem, nullptr);
  const StabilityCell in_row = try_cell(made, find_stepper("rk4"), 2, 1, job_.allowed_rad);
  const StabilityCell alone = try_cell_alone(made, find_stepper("rk4"), 2, 1, job_);
  EXPECT_EQ(in_row.outcome, alone.outcome);
  EXPECT_EQ(in_row.energy_drift, alone.energy_drift);
}

// upwards, too, may be steps; else the scene's own step holds
TEST_F(SceneOfMaps, StepsMayStandOnEitherAxis) {
  job_.x = "motion.spin.body[2]";
  job_.x_range = "2.9:3";
  job_.y = "numerics.step";
  job_.y_range = "0.001:5";
  const MappedScene made = prepared();
  const StepperInfo& rk4 = find_stepper("rk4");
  EXPECT_LT(try_cell(made, rk4, 0, 0, 0.1).error_rad, 1e-9);
  EXPECT_NE(try_cell(made, rk4, 0, 1, 0.1).outcome, RunOutcome::fine);
  test::write_text(folder_ / "scene.toml",
                   std::string(test::kSmallScene) + "[numerics]\nmethod = \"rk4\"\nstep = 0.02\n");
  job_.y = "spin";
  job_.y_range = "1:2";
  EXPECT_EQ(prepared().setup(0, 0).step, 0.02);
}

}  // namespace
}  // namespace polhode
