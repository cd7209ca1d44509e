// SPDX-License-Identifier: MIT
#include "scene/schema.h"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "base/json.h"
#include "scene/canonical.h"
#include "scene/scene_file.h"
#include "scene/scene_texts.h"

namespace polhode {
namespace {

TEST(Schema, HasEverySpellingWithItsUnit) {
  const Json solid = scene_schema()["properties"]["body"]["properties"]["solid"];
  EXPECT_EQ(solid["properties"]["radius"]["description"], "radius (m)");
  EXPECT_EQ(solid["properties"]["radius_cm"]["description"], "radius (cm)");
  EXPECT_EQ(solid["additionalProperties"], false);
  EXPECT_EQ(solid["required"], Json::array({"kind"}));
}

TEST(Schema, ConvertsRangesToTheUnitOfTheKey) {
  const Json camera = scene_schema()["properties"]["camera"]["properties"];
  EXPECT_EQ(camera["fov"]["maximum"], 2.6);
  EXPECT_NEAR(camera["fov_deg"]["maximum"].get<double>(), 148.969, 1e-3);
}

// whatever they round to in SI
TEST(Schema, LimitsAreAllowedThemselves) {
  const Json schema = scene_schema()["properties"];
  const Json attitude = schema["motion"]["properties"]["attitude"]["properties"];
  const auto reads = [](const std::string& line, const Json& value) {
    const std::string body = "[body]\nsolid = { kind = \"sphere\", radius = 1, mass = 1 }\n";
    EXPECT_NO_THROW(parse_scene(body + fmt::format(fmt::runtime(line), value.dump()), "t"));
  };
  for (const char* limit : {"minimum", "maximum"}) {
    reads("[motion.attitude]\nzxz_deg = [0, {}, 0]", attitude["zxz_deg"]["items"][limit]);
    reads("[motion.attitude]\ntilt_deg = {}", attitude["tilt_deg"][limit]);
    reads("[camera]\nfov_deg = {}", schema["camera"]["properties"]["fov_deg"][limit]);
  }
}

TEST(Schema, SharesTheVideoTable) {
  const Json video = scene_schema()["properties"]["video"]["properties"];
  EXPECT_TRUE(video.contains("fps"));
  EXPECT_TRUE(video.contains("theme"));
}

// check_schema.py runs this test alone and judges what it writes with an independent validator
TEST(Schema, IsWrittenForTheValidator) {
  const char* file = std::getenv("POLHODE_SCHEMA_CASES");
  if (file == nullptr) GTEST_SKIP() << "only for check_schema.py";
  Json cases{{"schema", scene_schema()}, {"good", Json::array()}, {"bad", Json::array()}};
  for (const SceneText& good : good_scenes()) {
    const Json canonical = scene_to_json(parse_scene(good.text, "t"));
    cases["good"].push_back({{"name", good.name}, {"text", good.text}, {"canonical", canonical}});
  }
  for (const BadSceneText& bad : bad_scenes()) {
    if (bad.schema_too) cases["bad"].push_back({{"name", bad.name}, {"text", bad.text}});
  }
  std::ofstream(file) << cases.dump(1);
}

}  // namespace
}  // namespace polhode
