// SPDX-License-Identifier: MIT
// Settings that change nothing in a film are told, and only those.
#include "film/unused_settings.h"

#include <gtest/gtest.h>

#include "film/overrides.h"
#include "film/small_films.h"
#include "support/logged.h"
#include "support/run.h"

namespace polhode {
namespace {

// what a small film with such a setting logs
std::string warnings_with(const std::vector<Setting>& settings) {
  Scene scene = parse_scene(test::kSmallScene, "scene.toml", settings);
  scene.video.size = {64, 48};
  return test::logged_by([&] {
    const PreparedFilm film(test::plan_of(scene));
    film.warn();
  });
}

struct Unused {
  Setting setting;  // changes nothing
  Setting needs;    // beside this it does
};

const std::vector<Unused> kUnused = {
    {{"show.ghost_count", "3"}, {"show.ghosts", "true"}},
    {{"show.ghost_interval", "0.1"}, {"show.ghosts", "true"}},
    {{"show.trail_length", "0.5"}, {"show.trail", "true"}},
    {{"story", R"([{ at = 0.5, hide = ["omega"] }])"}, {"show.omega", "true"}},
    {{"show.names.torque", "M"}, {"show.torque", "true"}},
    {{"show.names.x", "x"}, {"show.space_axes", "true"}},
    {{"show.names.y", "y"}, {"show.fixed_frame", "true"}},
    {{"show.vector_length", "2"}, {"show.trail_tips", "[omega]"}},
    {{"show.vector_length", "2"}, {"show.omega", "true"}},
    {{"show.material", "ceramic"}, {"show.body", "true"}},
    {{"show.torque", "true"}, {"motion.torque", R"([{ kind = "constant", space = [0, 0, 0.1] }])"}},
    {{"motion.torque", R"([{ kind = "constant", space = [0, 0, 0.1], from = 2 }])"},
     {"motion.duration", "3"}},
    {{"show.details", "true"}, {"numerics.compare", R"(["rk4"])"}},
    {{"show.title", "true"}, {"title", "Top"}},
    {{"video.loop_residual", "0.5"}, {"video.loop", "true"}},
    {{"camera.follow", "center"}, {"show.views", R"(["space"])"}},
    {{"body.pivot", "[0, 0, 0.1]"}, {"motion.hold", "pivot"}},
};

TEST(UnusedSettings, AreTold) {
  const std::vector<Setting> bare = {{"show.space_axes", "false"},
                                     {"show.body", "false"},
                                     {"show.omega", "false"},
                                     {"show.momentum", "false"},
                                     {"show.space_cone", "false"},
                                     {"show.body_cone", "false"},
                                     {"title", R"("")"},
                                     {"show.views", R"(["body"])"}};
  for (const Unused& one : kUnused) {
    std::vector<Setting> settings = bare;
    settings.push_back(one.setting);
    const std::string said = warnings_with(settings);
    EXPECT_NE(said.find("--set " + one.setting.key), std::string::npos)
        << one.setting.key << ": " << said;
    settings.push_back(one.needs);
    if (one.needs.key == "numerics.compare") settings.push_back({"numerics.step", "0.01"});
    EXPECT_EQ(warnings_with(settings).find("--set " + one.setting.key), std::string::npos)
        << one.setting.key;
  }
}

TEST(UnusedSettings, TheMethodBesideComparedOnesIsTold) {
  const Setting method = {"numerics.method", "dop853"};
  EXPECT_NE(warnings_with({method, {"numerics.compare", R"(["auto"])"}})
                .find("numerics.compare names the methods"),
            std::string::npos);
  EXPECT_EQ(warnings_with({method}), "");
}

TEST(UnusedSettings, AStepOfAnotherMethodIsTold) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "scene.toml",
                   std::string(test::kSmallScene) + "[numerics]\nmethod = \"rk4\"\nstep = 0.01\n");
  const auto told = [&](const Overrides& overrides) {
    const Scene scene = load_with_overrides(folder / "scene.toml", overrides);
    const std::vector<Error> unused = unused_in_motion(scene, scene.motion.duration);
    return unused.empty() ? "" : unused.front().place().key;
  };
  Overrides overrides;
  EXPECT_EQ(told(overrides), "");
  overrides.method = "rk4";
  EXPECT_EQ(told(overrides), "");
  overrides.method = "rk2";
  EXPECT_EQ(told(overrides), "numerics.step");
  overrides.step = 0.1;
  EXPECT_EQ(told(overrides), "");
}

TEST(UnusedSettings, AnEnsembleThatIsNotShownIsTold) {
  const Setting ensemble = {"motion.ensemble", "{ members = 3, tilt = 0.1 }"};
  EXPECT_EQ(warnings_with({ensemble}), "");
  EXPECT_NE(warnings_with({ensemble, {"show.ensemble", "false"}}).find("does not show it"),
            std::string::npos);
}

TEST(UnusedSettings, NamesInATableAreTold) {
  EXPECT_NE(warnings_with({{"show.names", R"({ torque = "M" })"}}).find("shows no torque"),
            std::string::npos);
}

// what the keys themselves take away from each other
TEST(UnusedSettings, WhatIsReplacedOrTooLongIsTold) {
  struct Replaced {
    Setting setting;
    Setting by;      // takes its use away
    Setting leaves;  // does not
  };
  const std::vector<Replaced> table = {
      {{"show.caption", "One"},
       {"story", R"([{ at = 0, caption = "Two" }])"},
       {"story", R"([{ at = 0.5, caption = "Two" }])"}},
      {{"camera.direction", "[1, 0, 0]"},
       {"shots", "[{ at = 0, direction = [0, 1, 0] }]"},
       {"shots", "[{ at = 0, move = 1, direction = [0, 1, 0] }]"}},
      {{"show.names", R"({ omega = "w" })"}, {"show.labels", "false"}, {"show.labels", "true"}},
      {{"show.trail", "true"}, {"show.trail_length", "2"}, {"show.trail_length", "0.5"}},
      {{"show.ghosts", "true"}, {"show.ghost_interval", "2"}, {"show.ghost_interval", "0.5"}},
  };
  for (const Replaced& one : table) {
    EXPECT_NE(warnings_with({one.setting, one.by}), "") << one.setting.key;
    EXPECT_EQ(warnings_with({one.setting, one.leaves}), "") << one.setting.key;
  }
}

TEST(UnusedSettings, PathsThatArePointsAreTold) {
  const Setting polhode = {"show.polhode", "true"}, herpolhode = {"show.herpolhode", "true"};
  const Setting about_an_axis = {"motion.spin.body", "[0, 0, 3]"};
  for (const Setting& path : {polhode, herpolhode}) {
    EXPECT_NE(warnings_with({path, about_an_axis}).find("--set " + path.key + ": shows nothing"),
              std::string::npos);
    EXPECT_EQ(warnings_with({path}), "");
  }
}

// an option sets all panels, and may be of use in one of them
TEST(UnusedSettings, OptionsCountForAllPanels) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.toml", test::kSmallScene);
  test::write_text(folder / "b.toml", test::kSmallScene);
  const auto warnings = [&](const std::string& of_first, const std::vector<Setting>& settings) {
    test::write_text(folder / "film.toml",
                     "[[panel]]\nscene = \"a.toml\"\ncaption = \"A\"\nset = { " + of_first +
                         " }\n[[panel]]\nscene = \"b.toml\"\ncaption = \"B\"\n");
    Scene scene = load_scene(folder / "film.toml", settings);
    for_each_scene(scene, [](Scene& one) { one.video.size = {64, 48}; });
    return test::logged_by([&] {
      const PreparedFilm film(test::plan_of(scene));
      film.warn();
    });
  };
  const std::string nothing = "\"show.omega\" = true";
  const Setting count = {"show.ghost_count", "3"};
  const std::string told = warnings(nothing, {count});
  EXPECT_NE(told.find("--set show.ghost_count: changes nothing"), std::string::npos) << told;
  EXPECT_EQ(told.find("ghost_count"), told.rfind("ghost_count")) << "once";
  EXPECT_EQ(warnings("\"show.ghosts\" = true", {count}), "");
  // the panels have one scale
  EXPECT_EQ(
      warnings("\"show.omega\" = false, \"show.momentum\" = false, \"show.space_cone\" = false, "
               "\"show.body_cone\" = false, \"show.vector_length\" = 0.5",
               {}),
      "");
  const Setting follow = {"camera.follow", "center"};
  EXPECT_EQ(warnings("\"show.views\" = [\"body\"]", {follow}), "");
}

TEST(UnusedSettings, OfShotsFromTheBodyAreTold) {
  const Setting views = {"show.views", R"(["body"])"};
  const Setting shots = {"shots", R"([{ at = 0.5, follow = "center" }])"};
  EXPECT_NE(warnings_with({views, shots}).find("all views are from the body"), std::string::npos);
  EXPECT_EQ(warnings_with({shots}), "");
}

}  // namespace
}  // namespace polhode
