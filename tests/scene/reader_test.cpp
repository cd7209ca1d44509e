// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/scene.h"
#include "scene/scene_texts.h"

namespace polhode {
namespace {

TEST(Reader, ReadsEveryGoodScene) {
  for (const SceneText& good : good_scenes()) {
    SCOPED_TRACE(good.name);
    EXPECT_NO_THROW(read(good.text));
  }
}

TEST(Reader, RefusesEveryBadSceneAtItsPlace) {
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

TEST(Reader, SaysItInOneLine) {
  try {
    read("[body]\nmomemts = [1, 2, 3]\n");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "test.toml:2: body.momemts: unknown key (did you mean 'moments'?)");
  }
}

TEST(Reader, FillsEveryTable) {
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

TEST(Reader, LeavesAbsentKeysAtTheirDefaults) {
  const Scene scene = read(kBody);
  EXPECT_EQ(scene.format, 1);
  EXPECT_EQ(scene.motion.duration, 10.0);
  EXPECT_FALSE(scene.motion.gravity);
  EXPECT_FALSE(scene.body.solid);
  EXPECT_TRUE(scene.show.asked.empty());
  EXPECT_EQ(scene.video.fps, FrameRate{});
}

TEST(Reader, CutsWhatIsAbsurdlyLong) {
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

TEST(Reader, KeepsControlCharactersOutOfMessages) {
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
