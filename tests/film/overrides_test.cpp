// SPDX-License-Identifier: MIT
#include "film/overrides.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

class OverridesOfAScene : public ::testing::Test {
 protected:
  OverridesOfAScene() {
    test::write_text(folder_ / "scene.toml",
                     std::string(test::kSmallScene) +
                         "[numerics]\nmethod = \"rk4\"\nstep = 0.01\ncompare = [\"rk2\"]\n");
  }
  Scene with(const Overrides& overrides) const {
    return load_with_overrides(folder_ / "scene.toml", overrides);
  }
  void expect_refused(const Overrides& overrides, const char* option, const char* words) const {
    test::expect_input_error([&] { with(overrides); }, option, words);
  }

  test::TemporaryFolder folder_;
};

TEST_F(OverridesOfAScene, WithoutAnyTheSceneIsAsItsFileSays) {
  const Scene scene = with({});
  EXPECT_EQ(scene.numerics.method, "rk4");
  EXPECT_EQ(scene.numerics.step, 0.01);
  EXPECT_EQ(scene.video.size.width, 128);
  EXPECT_EQ(scene.video.fps, (FrameRate{10, 1}));
  EXPECT_FALSE(scene.video.loop);
  EXPECT_TRUE(scene.options.empty());
}

TEST_F(OverridesOfAScene, EachGoesToItsKey) {
  Overrides all;
  all.step = 0.002;
  all.tolerance = 1e-9;
  all.accuracy = "0.5px";
  all.size = "64x48";
  all.fps = "30000/1001";
  all.loop = true;
  const Scene scene = with(all);
  EXPECT_EQ(scene.numerics.step, 0.002);
  EXPECT_EQ(scene.numerics.tolerance, 1e-9);
  EXPECT_EQ(scene.numerics.accuracy.value, 0.5);
  EXPECT_TRUE(scene.numerics.accuracy.pixels);
  EXPECT_EQ(scene.video.size.width, 64);
  EXPECT_EQ(scene.video.size.height, 48);
  EXPECT_EQ(scene.video.fps, (FrameRate{30000, 1001}));
  EXPECT_TRUE(scene.video.loop);
  EXPECT_EQ(scene.numerics.method, "rk4") << "it was not asked for";
  // errors that are found later can name the option
  const std::map<std::string, std::string> options = {{"numerics.step", "--step"},
                                                      {"numerics.tolerance", "--tolerance"},
                                                      {"numerics.accuracy", "--accuracy"},
                                                      {"video.size", "--size"},
                                                      {"video.fps", "--fps"}};
  std::map<std::string, std::string> named;
  for (const auto& [key, place] : scene.options)
    named[key] = place.key;
  EXPECT_EQ(named, options);
}

TEST_F(OverridesOfAScene, AThemeBringsItsOwnBackground) {
  test::write_text(
      folder_ / "scene.toml",
      std::string(test::kSmallScene) + "theme = \"light\"\nbackground = \"#123456\"\n");
  Overrides overrides;
  EXPECT_EQ(with(overrides).theme.background, "#123456");
  overrides.theme = "print";
  const Scene scene = with(overrides);
  EXPECT_EQ(scene.theme.theme, "print");
  EXPECT_FALSE(scene.theme.background);
  EXPECT_EQ(scene.options.at("video.theme").key, "--theme");
}

// the scene's step suits the scene's method; a comparison is of other methods
TEST_F(OverridesOfAScene, AnotherMethodLeavesTheScenesStepBehind) {
  Overrides other;
  other.method = "dopri5";
  Scene scene = with(other);
  EXPECT_EQ(scene.numerics.method, "dopri5");
  EXPECT_FALSE(scene.numerics.step);
  EXPECT_TRUE(scene.numerics.compare.empty());
  EXPECT_EQ(scene.options.at("numerics.method").key, "--method");
  other.step = 0.5;
  EXPECT_EQ(with(other).numerics.step, 0.5) << "a step of the command line is for this method";
  Overrides set;
  set.method = "rk2";
  set.settings = {{"numerics.step", "0.25"}};
  EXPECT_EQ(with(set).numerics.step, 0.25) << "and so is one that is set there";
  Overrides same;
  same.method = "rk4";
  scene = with(same);
  EXPECT_EQ(scene.numerics.step, 0.01);
  EXPECT_TRUE(scene.numerics.compare.empty());
  test::write_text(
      folder_ / "scene.toml",
      std::string(test::kSmallScene) + "[numerics]\nmethod = \"dopri5\"\ntolerance = 1e-6\n");
  EXPECT_FALSE(with(same).numerics.tolerance);
  EXPECT_EQ(with({}).numerics.tolerance, 1e-6);
  for (const char* word : {"auto", "exact"}) {
    Overrides by_word;
    by_word.method = word;
    EXPECT_EQ(with(by_word).numerics.method, word);
  }
}

TEST_F(OverridesOfAScene, WrongValuesNameTheirOption) {
  Overrides wrong;
  wrong.method = "rk44";
  expect_refused(wrong, "--method", "did you mean 'rk4'?");
  for (const double value : {0.0, -0.1, std::nan(""), HUGE_VAL}) {
    wrong = {};
    wrong.step = value;
    expect_refused(wrong, "--step", "greater than 0");
    wrong = {};
    wrong.tolerance = value;
    expect_refused(wrong, "--tolerance", "greater than 0");
  }
  wrong = {};
  wrong.accuracy = "often";
  expect_refused(wrong, "--accuracy", "");
  wrong = {};
  wrong.size = "64";
  expect_refused(wrong, "--size", "");
  wrong = {};
  wrong.fps = "29.97";
  expect_refused(wrong, "--fps", "30000/1001");
  wrong = {};
  wrong.theme = "prnit";
  expect_refused(wrong, "--theme", "did you mean 'print'?");
}

TEST_F(OverridesOfAScene, ErrorsOfTheFileKeepTheirLine) {
  test::write_text(folder_ / "scene.toml", "[body]\nmomnets = [1, 1, 2]\n");
  try {
    with({});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().file, folder_ / "scene.toml");
    EXPECT_EQ(error.place().line, 2);
  }
}

}  // namespace
}  // namespace polhode
