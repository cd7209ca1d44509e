// SPDX-License-Identifier: MIT
#include "export/recomputed.h"

#include <gtest/gtest.h>

#include "base/json.h"
#include "base/system/atomic_file.h"
#include "export/gltf_file.h"
#include "export/gltf_scene.h"
#include "export/viewer_data.h"
#include "film/solved_scene.h"
#include "scene/scene_file.h"
#include "support/scenes.h"

namespace polhode {
namespace {

struct Answer {
  Json about;
  std::string glb;
};

Answer ask(const Json& request) {
  const std::string answer = recomputed(request.dump());
  std::size_t size = 0;
  for (std::size_t i = 4; i-- > 0;)
    size = 256 * size + static_cast<unsigned char>(answer.at(i));
  return {Json::parse(answer.substr(4, size)), answer.substr(4 + size)};
}

Json request_of(const std::string& scene) {
  return {{"scene", read_file(test::scene_path(scene))},
          {"name", scene + ".toml"},
          {"settings", Json::array()}};
}

// what a page computes is what `export --set` writes, to the bit
TEST(Recomputed, IsWhatExportWritesWithTheseSettings) {
  Json request = request_of("free_symmetric_top");
  request["settings"] = Json::array({Json::array({"motion.duration", "2"}),
                                     Json::array({"motion.spin.rates_deg_per_s[2]", "500"})});
  request["from"] = 0.5;
  request["theme"] = "light";
  const Answer answer = ask(request);
  ASSERT_FALSE(answer.about.contains("error")) << answer.about;

  Scene scene = load_scene(test::scene_path("free_symmetric_top"),
                           {{"motion.duration", "2"}, {"motion.spin.rates_deg_per_s[2]", "500"}});
  scene.theme = {.theme = "light", .background = {}};
  const Solved solved = solve(scene);
  ExportPlan plan;
  plan.from = 0.5;
  EXPECT_EQ(answer.glb, glb_of(export_scene(solved, plan).document));
  EXPECT_EQ(answer.about.at("viewer"), viewer_data(solved, 0.5, 2.0));
  EXPECT_EQ(answer.about.at("doubts"), Json::array());
}

TEST(Recomputed, SaysWhatIsWrong) {
  Json request = request_of("free_symmetric_top");
  request["settings"] = Json::array({Json::array({"body.solid.mass", "-1"})});
  const Answer answer = ask(request);
  EXPECT_NE(answer.about.at("error").get<std::string>().find("mass"), std::string::npos)
      << answer.about;
  EXPECT_EQ(answer.glb, "");
  EXPECT_TRUE(ask({{"scene", 1}}).about.contains("error"));
  EXPECT_NE(recomputed("{").find("error"), std::string::npos);
}

}  // namespace
}  // namespace polhode
