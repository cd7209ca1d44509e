// SPDX-License-Identifier: MIT
// Every shipped scene loads, moves as its kind says, and renders one small frame.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "app/load.h"
#include "app/render_film.h"
#include "image/png.h"
#include "support/run.h"

namespace polhode {
namespace {

std::vector<std::string> scene_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(POLHODE_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path().stem().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string path_of(const std::string& scene) {
  return POLHODE_SOURCE_DIR "/scenes/" + scene + ".toml";
}

class EveryScene : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryScene, SaysWhatToLookAt) {
  const std::string text = test::read_text(path_of(GetParam()));
  EXPECT_EQ(text.rfind("# Look at:", 0), 0u);
  EXPECT_NE(text.find("# Closed form"), std::string::npos);
}

TEST_P(EveryScene, RendersOneSmallFrame) {
  const test::TemporaryFolder folder;
  RenderJob job;
  job.scene = path_of(GetParam());
  job.output = folder / "still.png";
  job.overrides.size = "240x136";
  job.still = 1.0;
  render_film(job);
  const Image image = read_png(job.output);
  EXPECT_EQ(image.width, 240);

  // something is there, and it is not all of the picture
  int other = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      other += std::equal(image.at(x, y), image.at(x, y) + 3, image.at(0, 0)) ? 0 : 1;
    }
  }
  EXPECT_GT(other, 240 * 136 / 50);
  EXPECT_LT(other, 240 * 136 * 3 / 4);
}

TEST_P(EveryScene, KeepsWhatIsConserved) {
  const Solved solved = solve(load_with_overrides(path_of(GetParam()), {}));
  EXPECT_LT(solved.simulation.report.record.drift.energy, 1e-6);
  EXPECT_LT(solved.simulation.report.record.drift.momentum, 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Scenes,
                         EveryScene,
                         ::testing::ValuesIn(scene_files()),
                         [](const auto& row) { return row.param; });

// the numbers that the first comments promise

Solved solved_scene(const std::string& name) {
  return solve(load_with_overrides(path_of(name), {}));
}

TEST(SceneNumbers, SymmetricTopsRepeatAsPromised) {
  for (const auto& [name, period, axis] : {std::tuple{"free_symmetric_top", 5.0, 24.0948},
                                           {"free_symmetric_top_oblate", 15.0, 52.8773}}) {
    const Motion& motion = solved_scene(name).simulation.motion;
    EXPECT_LT(motion.at(0.0).q_SB.angularDistance(motion.at(period).q_SB), 1e-9) << name;
    // L is vertical
    const Sample start = motion.at(0.0);
    EXPECT_LT(start.L_S.head<2>().norm(), 1e-12 * start.L_S.norm()) << name;
    EXPECT_NEAR(start.L_S.norm() / motion.model().moments[0] * 180 / kPi, 72.0, 1e-9) << name;
    static_cast<void>(axis);
  }
}

TEST(SceneNumbers, PlateWobblesTwicePerTurn) {
  const Motion& motion = solved_scene("feynman_plate").simulation.motion;
  const Sample start = motion.at(0.0);
  const double wobble = start.L_S.norm() / motion.model().moments[0];
  EXPECT_NEAR(start.w_B.z() * 180 / kPi, 180.0, 1e-6);
  EXPECT_NEAR(wobble / start.w_B.z(), 2.0 / std::cos(6 * kPi / 180), 1e-9);
}

TEST(SceneNumbers, THandleTurnsOver) {
  const Solved solved = solved_scene("t_handle");
  const Vec3 moments = solved.model.moments;
  Vec3 sorted = moments;
  std::sort(sorted.data(), sorted.data() + 3);
  // spun about the middle axis
  Eigen::Index axis = 0;
  solved.simulation.motion.at(0.0).w_B.cwiseAbs().maxCoeff(&axis);
  const Vec3 stem_P = solved.model.R_BP.transpose() * Vec3::Unit(axis);
  EXPECT_NEAR(stem_P.cwiseAbs2().dot(moments), sorted[1], 1e-6 * sorted[1]);
  int flips = 0;
  double before = 0.0;
  for (double t = 0.0; t <= 12.0; t += 0.01) {
    const double now = solved.simulation.motion.at(t).w_B.z();
    flips += before * now < 0.0 ? 1 : 0;
    before = now;
  }
  EXPECT_GE(flips, 3);
}

TEST(SceneNumbers, WheelStaysLevelAndPrecessesSteadily) {
  const Solved solved = solved_scene("bicycle_wheel");
  const Motion& motion = solved.simulation.motion;
  const Sample start = motion.at(0.0);
  const double expected = solved.model.chi_P.norm() / (solved.model.moments[2] * start.w_B.z());
  for (double t = 0.0; t <= 12.0; t += 0.5) {
    const Vec3 axle = motion.at(t).q_SB * Vec3::UnitZ();
    EXPECT_LT(std::abs(axle.z()), 1e-3) << t;
    const double angle = std::atan2(axle.y(), axle.x()) - std::atan2(-1.0, 0.0);
    EXPECT_LT(std::abs(std::remainder(angle - expected * t, 2 * kPi)), 2e-2) << t;
  }
}

TEST(SceneNumbers, HeavyTopFallsToTheSecondRootAndStopsAtCusps) {
  const Solved solved = solved_scene("heavy_top");
  const Model& m = solved.model;
  const Motion& motion = solved.simulation.motion;
  // released at rest: (u0 - u) (2 A mu - L3^2 (u0 - u) / ... ) -- the lower turning point is the
  // root of f(u)/(u - u0) = 0:  2 mu A (1 - u^2) = L3^2 (u0 - u)
  const double A = m.moments[0];
  const double mu = m.chi_P.norm();
  const double L3 = m.moments[2] * motion.at(0.0).w_B.z();
  const double u0 = std::cos(30 * kPi / 180);
  const double lambda = L3 * L3 / (2 * mu * A);
  const double u1 = 0.5 * (lambda - std::sqrt(lambda * lambda - 4 * (lambda * u0 - 1)));
  double lowest = 1.0;
  double highest = -1.0;
  for (double t = 0.0; t <= 6.0; t += 2e-4) {
    const double u = (motion.at(t).q_SB * Vec3::UnitZ()).z();
    lowest = std::min(lowest, u);
    highest = std::max(highest, u);
  }
  EXPECT_NEAR(highest, u0, 1e-5);
  EXPECT_NEAR(lowest, u1, 1e-4);
}

}  // namespace
}  // namespace polhode
