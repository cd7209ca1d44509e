// SPDX-License-Identifier: MIT
#include "film/solved_scene.h"

#include <cmath>

#include <gtest/gtest.h>

#include "film/small_films.h"
#include "math/so3.h"
#include "scene/scene_file.h"
#include "support/expect_error.h"
#include "support/logged.h"

namespace polhode {
namespace {

using test::small_scene;

// a free symmetric top: L/I1 about L, Omega_3 (1 - I3/I1) about its own axis
TEST(SolvedScene, TheMotionIsThatOfTheScene) {
  const Scene scene = small_scene();
  const Solved solved = solve(scene);
  EXPECT_EQ(solved.scene.title, "test");
  EXPECT_EQ(solved.simulation.report.method, "exact");
  const double I1 = 0.2 * (0.01 + 0.04), I3 = 0.2 * 0.02;
  EXPECT_NEAR(solved.model.moments.x(), I1, 1e-15);
  EXPECT_NEAR(solved.model.moments.z(), I3, 1e-15);
  const Quat start(Eigen::AngleAxisd(40.0 * kPi / 180.0, Vec3::UnitX()));
  const Vec3 L = start * Vec3(I1 * 1.0, 0.0, I3 * 3.0);
  const double t = 0.77;
  const Quat expected = Quat(Eigen::AngleAxisd(L.norm() / I1 * t, L.normalized())) * start *
                        Quat(Eigen::AngleAxisd(3.0 * (1.0 - I3 / I1) * t, Vec3::UnitZ()));
  EXPECT_LT(rotation_angle_between(solved.simulation.motion.at(t).q_SB, expected), 1e-13);
  EXPECT_GT(solved.simulate_time.wall_s, 0.0);
}

TEST(SolvedScene, ErrorsOfTheBodyNameTheirLine) {
  const Scene scene = parse_scene(
      "[body]\nmoments = [1, 1, 5]\n[motion]\nspin = { body = [1, 0, 3] }\n", "scene.toml");
  const std::string message = test::message_of([&] { solve(scene); });
  EXPECT_EQ(message.rfind("scene.toml:2: body.moments: ", 0), 0U) << message;
}

// the truth that methods are held against is not one of their steps
TEST(SolvedScene, StepsOfAComparisonAreNotThoseOfTheTruth) {
  const Scene scene =
      small_scene("[numerics]\ncompare = [\"rk4\", \"exact\"]\nstep = 0.3\ntolerance = 0.1\n");
  const SimulationReport& report = solve(scene).simulation.report;
  EXPECT_EQ(report.method, "exact");
  EXPECT_FALSE(report.step);
  EXPECT_FALSE(report.tolerance);
}

TEST(SolvedScene, StepsOfAComparisonAreNotThoseOfItsEnsemble) {
  Scene scene = small_scene("[numerics]\ncompare = [\"rk4\", \"exact\"]\nstep = 0.3\n");
  scene.motion.ensemble = EnsembleSpec{3, 0.1, 0.0};
  EXPECT_EQ(solve(scene).ensemble.size(), 3U);
  EXPECT_TRUE(solve(scene).simulation.report.reliability.doubts.empty());
}

// where only the motion of the scene is asked for, too
TEST(SolvedScene, AnEnsembleWhoseMotionsBeginAlikeIsRefused) {
  Scene scene = small_scene();
  scene.motion.ensemble = EnsembleSpec{3, 0.0, 0.0};
  const auto says = [](const auto& work) {
    return test::message_of(work);
  };
  for (const std::string& message :
       {says([&] { solve(scene); }), says([&] { solve_alone(scene, ProgressKind::none); })})
    EXPECT_NE(message.find("motion.ensemble: all its motions begin alike"), std::string::npos);
}

// each motion keeps its states
TEST(SolvedScene, AnEnsembleThatFillsTheMemoryIsRefused) {
  Scene scene = small_scene("[numerics]\nmodel = \"ode\"\nmethod = \"rk4\"\nstep = 1e-4\n");
  scene.motion.duration = 3.0;
  scene.motion.ensemble = EnsembleSpec{1000, 0.1, 0.0};
  test::expect_input_error(
      [&] { solve(scene); }, "motion.ensemble.members", "1000 motions of 30000 steps each");
}

TEST(SolvedScene, DoubtsAreLoggedWithTheLineOfTheMethod) {
  const Scene scene = small_scene("[numerics]\nmethod = \"explicit_euler\"\nstep = 0.1\n");
  const std::string said = test::logged_by(
      [&] { EXPECT_FALSE(solve(scene).simulation.report.reliability.doubts.empty()); });
  EXPECT_NE(said.find("scene.toml:13: numerics.method: the motion cannot be trusted: "),
            std::string::npos)
      << said;
  EXPECT_EQ(test::logged_by([] { solve(small_scene()); }), "");
}

// beyond the limit that theory knows, whatever comes of it; here from the command line
TEST(SolvedScene, AStepBeyondItsMethodIsWarnedOf) {
  Scene scene = small_scene("[numerics]\nmethod = \"rk4\"\n");
  scene.numerics.step = 5.0;
  scene.motion.duration = 10.0;
  scene.options["numerics.step"].key = "--step";
  const std::string said = test::logged_by([&] { solve(scene); });
  EXPECT_NE(said.find("--step: a step of 5 s is beyond "), std::string::npos) << said;
}

TEST(AccuracyInRadians, IsWhatTheSceneSays) {
  Scene scene = small_scene("[numerics]\naccuracy = 0.02\n");
  EXPECT_EQ(accuracy_in_radians(scene, solve(scene).model), 0.02);
}

// it is the distance of the body that counts, wherever the camera looks, and of its nearest place
TEST(AccuracyInRadians, PixelsDependOnWhereTheBodyIs) {
  Scene scene = small_scene("[numerics]\naccuracy = \"0.5px\"\n");
  scene.camera.eye = Vec3(0.0, -4.0, 0.0);
  scene.camera.target = Vec3::Zero();
  const BodyModel model = solve(scene).model;
  const double there = accuracy_in_radians(scene, model);
  scene.camera.target = Vec3(0.0, 40.0, 0.0);
  EXPECT_NEAR(accuracy_in_radians(scene, model), there, 1e-12);
  const double near = accuracy_in_radians(scene, model, {Vec3::Zero(), Vec3(0.0, -2.0, 0.0)});
  EXPECT_LT(near, 0.6 * there);
  EXPECT_GT(near, 0.3 * there);
}

// pixels are angles: of twice as many rows half the angle, of a nearer camera less
TEST(AccuracyInRadians, PixelsDependOnThePicture) {
  Scene scene = small_scene("[numerics]\naccuracy = \"0.5px\"\n");
  const BodyModel model = solve(scene).model;
  const double coarse = accuracy_in_radians(scene, model);
  scene.video.size = {128, 96};
  EXPECT_NEAR(accuracy_in_radians(scene, model), coarse / 2.0, 1e-9 * coarse);
  scene.numerics.accuracy.value = 1.0;
  EXPECT_NEAR(accuracy_in_radians(scene, model), coarse, 1e-9 * coarse);
  scene.camera.eye = Vec3(0.0, -3.0, 0.0);
  const double far = accuracy_in_radians(scene, model);
  ShotSpec shot;
  shot.camera.eye = Vec3(0.0, -2.0, 0.0);
  scene.shots = {shot};
  const double near = accuracy_in_radians(scene, model);
  EXPECT_LT(near, far);
  std::swap(scene.camera, scene.shots[0].camera);
  EXPECT_EQ(accuracy_in_radians(scene, model), near);
  scene.shots[0].camera.eye = Vec3::Zero();
  test::expect_error(
      [&] { accuracy_in_radians(scene, model); }, Fault::input, "shots[0].eye", "must differ");
  scene.shots.clear();
  EXPECT_EQ(accuracy_in_radians(scene, model), near);
}

// a point outside of the body is the farthest, wherever it is listed
TEST(SolvedScene, PointsOfTheSceneCountForTheAccuracy) {
  Scene scene = small_scene("[numerics]\naccuracy = \"0.5px\"\n[camera]\neye = [4, 0, 0]\n");
  const BodyModel model = solve(scene).model;
  const double alone = accuracy_in_radians(scene, model);
  scene.show.points = {Vec3(0.0, 0.0, 0.05)};
  EXPECT_EQ(accuracy_in_radians(scene, model), alone);
  scene.show.points.push_back(Vec3(1.0, 0.0, 0.0));
  const double with_point = accuracy_in_radians(scene, model);
  EXPECT_LT(with_point, 0.5 * alone);
  std::swap(scene.show.points, scene.show.trail_points);
  EXPECT_EQ(accuracy_in_radians(scene, model), with_point);
}

// a turn by the accuracy moves no point of the body by more than the pixels that are allowed
TEST(AccuracyInRadians, MovesNothingByMoreThanItsPixels) {
  Scene scene = small_scene("[numerics]\naccuracy = \"0.5px\"\n");
  scene.camera.eye = Vec3(0.0, -3.0, 0.0);
  scene.camera.target = Vec3::Zero();
  const Solved solved = solve(scene);
  const double angle = accuracy_in_radians(scene, solved.model);
  // vectors reach 1.5 times as far as the ellipsoid's tip, and may point at the camera
  const double reach = 1.5 * 0.2, focal_length = 24.0 / std::tan(0.5 * scene.camera.fov);
  EXPECT_NEAR(angle * reach * focal_length / (3.0 - reach), 0.5, 0.02);
}

}  // namespace
}  // namespace polhode
