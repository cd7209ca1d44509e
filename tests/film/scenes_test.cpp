// SPDX-License-Identifier: MIT
// Every shipped scene loads, moves as its kind says, and renders one small frame.
#include "support/scenes.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "app/commands/render.h"
#include "film/overrides.h"
#include "film/solved_scene.h"
#include "frame/compose.h"
#include "frame/elements.h"
#include "image/png.h"
#include "scene/scene_file.h"
#include "support/logged.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::scene_names;
using test::scene_path;

class EveryScene : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryScene, SaysWhatToLookAt) {
  const std::string text = test::read_text(scene_path(GetParam()));
  EXPECT_EQ(text.rfind("# Look at:", 0), 0u);
  EXPECT_NE(text.find("# Closed form"), std::string::npos);
}

// the shipped scenes show everything that can be shown
TEST(AllScenes, TogetherShowEveryName) {
  std::set<std::string> missing;
  for (const Element& element : elements())
    missing.insert(element.name);
  for (const std::string& name : scene_names()) {
    const Scene scene = load_scene(scene_path(name));
    const Solved solved = solve(scene);
    Staging staging;
    staging.camera = scene.camera;
    staging.timeline = Timeline({}, scene.motion.duration, 1.0);
    Shared shared;
    shared.ensemble = solved.ensemble;
    const Composer picture(
        solved.simulation.motion, scene.body, staging, scene.show, scene.theme, {320, 180}, shared);
    for (const Element& element : elements()) {
      if (picture.shows(element.name)) missing.erase(element.name);
    }
  }
  EXPECT_TRUE(missing.empty()) << *missing.begin();
}

TEST_P(EveryScene, RendersOneSmallFrame) {
  const test::TemporaryFolder folder;
  RenderJob job;
  job.scene = scene_path(GetParam());
  job.output = folder / "still.png";
  job.overrides.size = "240x136";
  job.still = std::min(1.0, load_scene(job.scene).motion.duration / 2);
  const std::string said = test::logged_by([&] { render_film(job); });
  EXPECT_EQ(said.find("changes nothing here"), std::string::npos) << said;
  const Image image = read_png(job.output);
  EXPECT_EQ(image.width, 240);

  // something is there, and it is not all of the picture
  int other = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      other += std::equal(image.at(x, y), image.at(x, y) + 3, image.at(0, 0)) ? 0 : 1;
    }
  }
  EXPECT_GT(other, 240 * 136 / 100);
  EXPECT_LT(other, 240 * 136 * 3 / 4);
}

TEST_P(EveryScene, KeepsWhatIsConserved) {
  const Solved solved = solve(load_with_overrides(scene_path(GetParam()), {}));
  // absent where torques change it
  EXPECT_LT(solved.simulation.report.record.drift.energy.value_or(0.0), 1e-6);
  EXPECT_LT(solved.simulation.report.record.drift.momentum.value_or(0.0), 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Scenes,
                         EveryScene,
                         ::testing::ValuesIn(scene_names()),
                         [](const auto& row) { return row.param; });

}  // namespace
}  // namespace polhode
