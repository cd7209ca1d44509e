// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/scene.h"
#include "scene/scene_texts.h"

namespace polhode {
namespace {

const std::string kBody = "[body]\nmoments = [1, 2, 3]\n";

Scene read(const std::string& text) {
  return parse_scene(text, "test.toml");
}

TEST(Reader, reads_every_good_scene) {
  for (const SceneText& good : good_scenes()) {
    SCOPED_TRACE(good.name);
    EXPECT_NO_THROW(read(good.text));
  }
}

TEST(Reader, refuses_every_bad_scene_at_its_place) {
  for (const BadSceneText& bad : bad_scenes()) {
    SCOPED_TRACE(bad.name);
    try {
      read(bad.text);
      ADD_FAILURE() << "was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.fault(), Fault::input);
      EXPECT_EQ(error.place().file, "test.toml");
      EXPECT_EQ(error.place().line, bad.line) << error.what();
      EXPECT_EQ(error.place().key, bad.key) << error.what();
      EXPECT_NE(error.message().find(bad.message), std::string::npos) << error.what();
      EXPECT_LT(error.message().size(), 600u) << error.what();
    }
  }
}

TEST(Reader, says_it_in_one_line) {
  try {
    read("[body]\nmomemts = [1, 2, 3]\n");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "test.toml:2: body.momemts: unknown key (did you mean 'moments'?)");
  }
}

TEST(Reader, fills_every_table) {
  const Scene scene = read(good_scenes().front().text);
  EXPECT_EQ(scene.title, "Free precession of a symmetric top");
  EXPECT_EQ(*scene.body.moments, Vec3(1.0, 1.0, 1.8));
  EXPECT_EQ(scene.body.look->kind, "lathe");
  EXPECT_EQ(scene.body.look->profile.at(1), Vec2(0.4, 0.3));
  EXPECT_EQ(*scene.body.look->color, "#Ff8800");
  EXPECT_EQ(*scene.motion.gravity, Vec3(0, 0, -9.81));
  EXPECT_EQ(*scene.motion.spin.body, Vec3(0.3, 0, 5));
  EXPECT_EQ(*scene.numerics.step, 0.001);
  EXPECT_TRUE(scene.numerics.accuracy.pixels);
  EXPECT_EQ(*scene.camera.eye, Vec3(3, 0, 1));
  EXPECT_EQ(scene.show.asked.at("space_axes"), std::optional<bool>(false));
  EXPECT_EQ(scene.video.time_scale, 0.5);
  EXPECT_EQ(scene.theme.theme, "dark");
  EXPECT_EQ(*scene.theme.background, "#102030");
  EXPECT_EQ(scene.file, "test.toml");
}

TEST(Reader, leaves_absent_keys_at_their_defaults) {
  const Scene scene = read(kBody);
  EXPECT_EQ(scene.format, 1);
  EXPECT_EQ(scene.motion.duration, 10.0);
  EXPECT_FALSE(scene.motion.gravity);
  EXPECT_FALSE(scene.body.solid);
  EXPECT_TRUE(scene.show.asked.empty());
  EXPECT_EQ(scene.video.fps, FrameRate{});
}

TEST(Reader, converts_units_to_the_last_bit) {
  const Scene scene = read(
      "[body]\nparts = [{ kind = \"rod\", length_mm = 7, radius_cm = 35, mass_g = 12, turn_deg = "
      "[90, 0, "
      "-180], at_km = [1, 0.5, 0], density_g_per_cm3 = 2.7 }]\n[motion]\nduration_ms = 1500\nspin "
      "= { "
      "space_rpm = [60, 0, 0] }\n");
  const SolidSpec& rod = scene.body.parts.at(0);
  EXPECT_EQ(*rod.length, 0.007);
  EXPECT_EQ(*rod.radius, 0.35);
  EXPECT_EQ(*rod.mass, 0.012);
  EXPECT_EQ(rod.turn, Vec3(kPi / 2, 0, -kPi));
  EXPECT_EQ(rod.at, Vec3(1000, 500, 0));
  EXPECT_EQ(*rod.density, 2700.0);
  EXPECT_EQ(scene.motion.duration, 1.5);
  EXPECT_DOUBLE_EQ(scene.motion.spin.space->x(), 2 * kPi);
}

TEST(Reader, keeps_matrix_rows) {
  const Scene scene = read("[body]\ntensor_g_cm2 = [[1, 2, 3], [4, 5, 6], [7, 8, 9]]\n");
  EXPECT_DOUBLE_EQ((*scene.body.tensor)(0, 2), 3e-7);
  EXPECT_DOUBLE_EQ((*scene.body.tensor)(2, 0), 7e-7);
}

TEST(Reader, takes_sizes_rates_and_accuracies_in_each_form) {
  EXPECT_EQ(read(kBody + "[video]\nsize = \"640x480\"").video.size, (PictureSize{640, 480}));
  EXPECT_EQ(read(kBody + "[video]\nsize = [640, 480]").video.size, (PictureSize{640, 480}));
  EXPECT_EQ(read(kBody + "[video]\nfps = 25").video.fps, (FrameRate{25, 1}));
  EXPECT_EQ(read(kBody + "[video]\nfps = \"30000/1001\"").video.fps, (FrameRate{30000, 1001}));
  const Scene radians = read(kBody + "[numerics]\naccuracy = 1e-6");
  EXPECT_EQ(radians.numerics.accuracy.value, 1e-6);
  EXPECT_FALSE(radians.numerics.accuracy.pixels);
  const Scene pixels = read(kBody + "[numerics]\naccuracy = \"0.25px\"");
  EXPECT_EQ(pixels.numerics.accuracy.value, 0.25);
  EXPECT_TRUE(pixels.numerics.accuracy.pixels);
}

TEST(LineOf, finds_the_key_or_what_is_around_it) {
  const Scene scene = read(
      "[body]\n\nparts = [\n{ kind = \"rod\", length = 1 },\n{ kind = \"rod\", radius_cm = 1 "
      "},\n]\n"
      "[motion.attitude]\nzxz_deg = [0,\n0, 0]\n");
  EXPECT_EQ(line_of(scene, "body"), 1);
  EXPECT_EQ(line_of(scene, "body.parts"), 3);
  EXPECT_EQ(line_of(scene, "body.parts[1]"), 5);
  EXPECT_EQ(line_of(scene, "body.parts[1].radius"), 5);
  EXPECT_EQ(line_of(scene, "body.parts[0].radius"), 4);
  EXPECT_EQ(line_of(scene, "body.parts[7].radius"), 3);
  EXPECT_EQ(line_of(scene, "body.mass"), 1);
  EXPECT_EQ(line_of(scene, "motion.attitude.zxz"), 8);
  EXPECT_EQ(line_of(scene, "motion.attitude.zxz[1]"), 8);
  EXPECT_EQ(line_of(scene, "video.fps"), 0);
  EXPECT_EQ(line_of(scene, ""), 0);
}

TEST(Reader, cuts_what_is_absurdly_long) {
  const std::string key(100000, 'k');
  const std::string value(100000, 'v');
  for (const std::string& text : {kBody + key + " = 1\n", kBody + "about = \"" + value + "\"\n"}) {
    try {
      read(text);
      FAIL();
    } catch (const Error& error) {
      EXPECT_LT(std::string(error.what()).size(), 1000u);
    }
  }
}

TEST(Reader, keeps_control_characters_out_of_messages) {
  try {
    read(kBody + "\"\\u001b[2J\\n\" = 1\n");
    FAIL();
  } catch (const Error& error) {
    for (const char c : std::string(error.what()))
      EXPECT_GE(static_cast<unsigned char>(c), 0x20);
  }
}

}  // namespace
}  // namespace polhode
