// SPDX-License-Identifier: MIT
#include "lecture/turning.h"

#include <gtest/gtest.h>

#include "base/base64.h"
#include "export/viewer_data.h"
#include "film/solved_scene.h"
#include "lecture/decks.h"
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

// numbers at equal steps, and the stops and words of the story
TEST(Turning, TheDataAreThoseOfTheMotion) {
  const Solved solved = solve(load_scene(test::scene_path("cones_explained")));
  const Motion& motion = solved.simulation.motion;
  const double to = motion.duration();
  const Json data = viewer_data(solved, 1.0, to);
  const Json& omega = data.at("series").at("omega");
  const std::size_t steps = omega.size() - 1;
  for (const std::size_t i : {std::size_t{0}, steps / 3, steps}) {
    const double t = 1.0 + (to - 1.0) * static_cast<double>(i) / static_cast<double>(steps);
    EXPECT_NEAR(omega.at(i), motion.at(t).w_S.norm(), 1e-12);
  }
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
