// SPDX-License-Identifier: MIT
#include "scene/canonical.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/json.h"
#include "scene/scene_file.h"
#include "scene/scene_texts.h"
#include "support/run.h"

namespace polhode {
namespace {

std::string hash_of(const std::string& text) {
  return scene_hash(parse_scene(text, "t"));
}

// a TOML inline value from canonical JSON, to read it again
std::string inline_toml(const Json& json) {
  if (json.is_array()) {
    std::string text;
    for (const auto& element : json)
      text += inline_toml(element) + ", ";
    return "[" + text + "]";
  }
  if (!json.is_object()) return json.dump();
  std::string text;
  for (const auto& [key, value] : json.items())
    text += (text.empty() ? "" : ", ") + key + " = " + inline_toml(value);
  return "{ " + text + " }";
}

std::string toml_of(const Json& json) {
  std::string text;
  for (const auto& [key, value] : json.items())
    text += key + " = " + inline_toml(value) + "\n";
  return text;
}

TEST(Canonical, ReadsBackAsTheSameScene) {
  for (const SceneText& good : good_scenes()) {
    SCOPED_TRACE(good.name);
    const Scene scene = parse_scene(good.text, "t");
    const std::string again = toml_of(scene_to_json(scene));
    EXPECT_EQ(scene_to_json(parse_scene(again, "t")).dump(), scene_to_json(scene).dump());
  }
}

TEST(Canonical, IsInSiAndResolved) {
  const Json json =
      scene_to_json(parse_scene("[body]\nsolid = { kind = \"sphere\", radius_cm = 12, mass_g = 300 "
                                "}\n[video]\nfps = \"30000/1001\"\n",
                                "t"));
  EXPECT_EQ(json["body"]["solid"]["radius"], 0.12);
  EXPECT_EQ(json["body"]["solid"]["mass"], 0.3);
  EXPECT_FALSE(json["body"].contains("moments"));
  EXPECT_FALSE(json["body"].contains("points"));
  EXPECT_EQ(json["motion"]["duration"], 10.0);
  EXPECT_EQ(json["numerics"]["accuracy"], "0.1px");
  EXPECT_EQ(json["video"]["fps"], "30000/1001");
  EXPECT_EQ(json["video"]["size"], Json::array({1920, 1080}));
  EXPECT_EQ(json["video"]["theme"], "dark");
  EXPECT_FALSE(json.contains("file"));
}

// pairs of texts that mean the same
TEST(Canonical, TheHashDoesNotSeeSpelling) {
  const std::vector<std::pair<std::string, std::string>> same = {
      {kBody, "# comment\n\n[body]   # another\nmoments = [1.0, 2e0, 3,]\r\n"},
      {kBody, "body.moments = [1, 2, 3]\nformat = 1\n"},
      {kBody, "body = { moments = [1, 2, 3] }\n"},
      {kBody + "[motion]\nduration = 10\n", kBody + "[motion]\nduration_ms = 10000\n"},
      {kBody + "mass = 0.35\n", "[body]\nmass_g = 350\nmoments = [1, 2, 3]\n"},
      {kBody + "pivot = [0.35, 0, -0.07]\n", kBody + "pivot_cm = [35, 0, -7]\n"},
      {kBody + "pivot = [0, 0, 0]\n", kBody + "pivot = [0, -0.0, 0]\n"},
      {kBody + "[camera]\nfov = 0.5235987755982988\n", kBody + "[camera]\nfov_deg = 30\n"},
      {kBody + "[video]\nfps = 60\n", kBody + "[video]\nfps = \"60\"\n"},
      {kBody + "[video]\nsize = [640, 480]\n", kBody + "[video]\nsize = \"640x480\"\n"},
      {kBody + "[motion]\n[video]\n", "[video]\n" + kBody + "[numerics]\n[show]\n"},
      {kBody + "[numerics]\naccuracy = 1\n", kBody + "[numerics]\naccuracy = 1.0\n"},
  };
  for (const auto& [one, other] : same)
    EXPECT_EQ(hash_of(one), hash_of(other)) << other;
  EXPECT_EQ(scene_hash(parse_scene(kBody, "a")), scene_hash(parse_scene(kBody, "b")));
}

// scenes that differ in one value each
TEST(Canonical, TheHashSeesEveryValue) {
  const std::string solid = "[body]\nsolid = { kind = \"box\", mass = 1 ";
  std::vector<std::string> texts = {kBody,
                                    "title = \"x\"\n" + kBody,
                                    "[body]\nmoments = [1, 2, 3.0000000000000004]\n",
                                    "[body]\nmoments = [2, 1, 3]\n",
                                    "[body]\ntensor = [[1, 0, 0], [0, 2, 0], [0, 0, 3]]\n",
                                    "[body]\ntensor = [[1, 0, 0.1], [0, 2, 0], [0, 0, 3]]\n",
                                    "[body]\ntensor = [[1, 0, 0], [0, 2, 0], [0.1, 0, 3]]\n",
                                    "[body]\npoints = [{ m = 1, at = [0, 0, 1] }]\n",
                                    "[body]\npoints = [{ m = 2, at = [0, 0, 1] }]\n",
                                    "[body]\npoints = [{ m = 1, at = [0, 1, 0] }]\n",
                                    "[body]\nparts = [{ kind = \"box\", mass = 1 }]\n",
                                    "[body]\nsolid = { kind = \"sphere\", mass = 1 }\n",
                                    "[body]\nsolid = { kind = \"box\", density = 1 }\n",
                                    solid + "}\n"};
  for (const char* key : {"size = [1, 2, 3]",
                          "semi_axes = [1, 2, 3]",
                          "radius = 1",
                          "height = 1",
                          "length = 1",
                          "thickness = 1",
                          "tube = 1",
                          "profile = [[0, 1]]",
                          "profile = [[0, 1], [1, 1]]",
                          "at = [1, 0, 0]",
                          "turn = [1, 0, 0]",
                          "color = \"#000000\""}) {
    texts.push_back(solid + ", " + key + " }\n");
  }
  for (const char* key : {"about = \"pivot\"",
                          "mathematical = true",
                          "mass = 1",
                          "mass = 2",
                          "center_of_mass = [0, 0, 1]",
                          "pivot = [0, 0, 1]",
                          "look = { kind = \"box\" }",
                          "look = { kind = \"sphere\" }"}) {
    texts.push_back(kBody + key + "\n");
  }
  const std::map<std::string, std::vector<std::string>> tables = {
      {"motion",
       {"hold = \"pivot\"",
        "gravity = [0, 0, 0]",
        "gravity = [0, 0, -9.81]",
        "duration = 9",
        "attitude = { zxz = [0, 0, 0] }",
        "attitude = { zxz = [0, 1, 0] }",
        "attitude = { quaternion = [1, 0, 0, 0] }",
        "spin = { body = [0, 0, 1] }",
        "spin = { space = [0, 0, 1] }",
        "spin = { momentum_body = [0, 0, 1] }",
        "spin = { rates = [0, 0, 1] }",
        "position = [0, 0, 1]",
        "velocity = [0, 0, 1]"}},
      {"numerics",
       {"model = \"" + model_names().back() + "\"",
        "method = \"" + method_names().back() + "\"",
        "step = 0.1",
        "tolerance = 0.1",
        "accuracy = 0.1",
        "accuracy = 0.2",
        "accuracy = \"0.2px\""}},
      {"camera", {"eye = [1, 0, 0]", "target = [1, 0, 0]", "fov = 1", "direction = [1, 0, 0]"}},
      {"show",
       {"body = true",
        "body = false",
        "axes = true",
        "space_axes = true",
        "omega = true",
        "momentum = true",
        "space_cone = true",
        "body_cone = true",
        "precession_cone = true",
        "pivot = true"}},
      {"video",
       {"size = [640, 480]",
        "size = [480, 640]",
        "fps = 30",
        "fps = \"30000/1001\"",
        "time_scale = 2",
        "theme = \"" + theme_names().back() + "\"",
        "background = \"#000000\""}}};
  for (const auto& [table, keys] : tables) {
    for (const std::string& key : keys)
      texts.push_back(kBody + "[" + table + "]\n" + key + "\n");
  }

  std::map<std::string, std::string> seen;
  for (const std::string& text : texts) {
    const auto [entry, is_new] = seen.emplace(hash_of(text), text);
    EXPECT_TRUE(is_new) << text << "has the hash of\n" << entry->second;
  }
}

TEST(Canonical, TheHashSeesWhatAMeshFileHolds) {
  const test::TemporaryFolder folder;
  std::set<std::string> hashes;
  for (const char* tip : {"1", "2"}) {
    test::write_text(folder / "tip.obj",
                     std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 ") + tip +
                         "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    test::write_text(folder / "scene.toml",
                     "[body]\nsolid = { kind = \"mesh\", file = \"tip.obj\", mass = 1 }\n");
    hashes.insert(scene_hash(load_scene(folder / "scene.toml")));
  }
  EXPECT_EQ(hashes.size(), 2u);
}

}  // namespace
}  // namespace polhode
