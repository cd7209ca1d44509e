// SPDX-License-Identifier: MIT
#include "lecture/documents/turning.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/base64.h"
#include "export/viewer_data.h"
#include "film/solved_scene.h"
#include "lecture/decks.h"
#include "motion/deviation.h"
#include "scene/scene_file.h"
#include "support/run.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::deck_of;
using test::TemporaryFolder;

TEST(Turning, ADeckThatHasOneHasViewers) {
  EXPECT_TRUE(has_viewers(deck_of("![](a.toml){.turn clock=both}\n")));
  EXPECT_FALSE(has_viewers(deck_of("![](a.toml){.film}\n")));
  EXPECT_NE(test::problem_of("![](a.toml){.turn keys=kind}\n").find("a .turn has no 'keys'"),
            std::string::npos);
}

// what a page makes of the readings at a time between them
double read_out(const Json& data, const char* name, double t) {
  const Json& times = data.at("series").at("times");
  const Json& values = data.at("series").at(name);
  std::size_t i = 0;
  while (i + 2 < times.size() && times.at(i + 1).get<double>() <= t)
    ++i;
  const double a = times.at(i), b = times.at(i + 1), from = values.at(i), to = values.at(i + 1);
  return from + (t - a) / (b - a) * (to - from);
}

// numbers that are right in four digits at any time, also where they swing fast
TEST(Turning, NumbersReadOutAreThoseOfTheMotion) {
  for (const char* name : {"cones_explained", "rattleback", "spring"}) {
    SCOPED_TRACE(name);
    const Solved solved = solve(load_scene(test::scene_path(name)));
    const Motion& motion = solved.simulation.motion;
    const Json data = viewer_data(solved, 0.5, motion.duration());
    EXPECT_EQ(data.at("series").at("digits"), 4);
    EXPECT_LT(data.at("series").at("times").size(), 20'000u);
    double omega = 0.0, momentum = 0.0, energy = 0.0;
    for (const double t : scattered_times(motion.duration(), 500)) {
      omega = std::max(omega, motion.at(t).w_S.norm());
      momentum = std::max(momentum, motion.at(t).L_S.norm());
      energy = std::max(energy, std::abs(motion.at(t).energy));
    }
    for (const double t : scattered_times(motion.duration(), 200, 7)) {
      if (t < 0.5) continue;
      const Sample now = motion.at(t);
      EXPECT_NEAR(read_out(data, "omega", t), now.w_S.norm(), 1.5e-4 * omega) << t;
      EXPECT_NEAR(read_out(data, "momentum", t), now.L_S.norm(), 1.5e-4 * momentum) << t;
      EXPECT_NEAR(read_out(data, "energy", t), now.energy, 1.5e-4 * energy) << t;
    }
  }
}

TEST(Turning, TheVerticalIsAgainstGravity) {
  Scene scene = load_scene(test::scene_path("heavy_top"));
  scene.motion.gravity = Vec3(6.0, 0.0, -8.0);
  scene.motion.duration = 0.1;
  const Json data = viewer_data(solve(scene), 0.0, 0.1);
  // in axes in which Y is up
  EXPECT_NEAR(data.at("up").at(0), -0.6, 1e-15);
  EXPECT_NEAR(data.at("up").at(1), 0.8, 1e-15);
  EXPECT_NEAR(data.at("up").at(2), 0.0, 1e-15);
}

// and the stops and words of the story
TEST(Turning, TheDataHaveTheStory) {
  const Solved solved = solve(load_scene(test::scene_path("cones_explained")));
  const Json data = viewer_data(solved, 1.0, solved.simulation.motion.duration());
  EXPECT_FALSE(data.at("captions").empty());
  for (const Json& pause : data.at("pauses"))
    EXPECT_GE(double(pause.at("at")), 1.0);  // those before the start are left out
  EXPECT_TRUE(data.at("elements").contains("omega"));
}

TEST(Turning, PlotsAreCurvesOverTheWholeMotion) {
  const Solved solved = solve(load_scene(test::scene_path("nutation_plots")));
  const Json plots = viewer_data(solved, 0.0, solved.simulation.motion.duration()).at("plots");
  ASSERT_EQ(plots.size(), 3u);
  EXPECT_EQ(plots.at(2).at("curves").size(), 3u);
  EXPECT_GT(plots.at(0).at("curves").at(0).at("values").size(), 100u);
}

// what ends a script, or begins a comment, cannot stand in a block of data
TEST(Turning, NothingInABlockEndsIt) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "media");
  const std::string evil = "</script><script>alert(1)</script><!--";
  test::write_text(folder / "media/a.glb", "glTF" + evil);
  test::write_text(folder / "media/a.json", Json{{"title", evil}}.dump());
  const Deck deck = deck_of("![](a.toml){#n .turn}\n");
  const FigureOf figure_of = [&](const DeckPicture& picture) {
    return Figure{&picture, {{"glb", "a.glb"}, {"viewer", "a.json"}}, ""};
  };
  const std::string blocks = viewer_blocks(deck, figure_of, folder.path(), {"1", "let three;", ""});
  EXPECT_EQ(blocks.find("alert(1)</"), std::string::npos);
  EXPECT_EQ(blocks.find("<!--"), std::string::npos);
  EXPECT_NE(blocks.find(base64("glTF" + evil)), std::string::npos);
  const std::size_t from = blocks.find('>') + 1, end = blocks.find("</script>");
  EXPECT_EQ(Json::parse(blocks.substr(from, end - from)).at("title"), evil);
  EXPECT_NE(blocks.find("<script type=\"text/plain\" data-three>let three;</script>"),
            std::string::npos);
}

TEST(Turning, WithoutAModelThereIsNothing) {
  const Deck deck = deck_of("![](a.toml){.turn}\n");
  const FigureOf failed = [](const DeckPicture& picture) {
    return Figure{&picture, {}, "it cannot be"};
  };
  EXPECT_EQ(viewer_blocks(deck, failed, ".", {"1", "let three;", ""}), "");
}

}  // namespace
}  // namespace polhode
