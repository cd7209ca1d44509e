// SPDX-License-Identifier: MIT
// Settings that change nothing in a film are told, and only those.
#include "film/unused_settings.h"

#include <gtest/gtest.h>

#include "film/small_films.h"
#include "support/logged.h"

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

TEST(UnusedSettings, OfShotsFromTheBodyAreTold) {
  const Setting views = {"show.views", R"(["body"])"};
  const Setting shots = {"shots", R"([{ at = 0.5, follow = "center" }])"};
  EXPECT_NE(warnings_with({views, shots}).find("all views are from the body"), std::string::npos);
  EXPECT_EQ(warnings_with({shots}), "");
}

}  // namespace
}  // namespace polhode
