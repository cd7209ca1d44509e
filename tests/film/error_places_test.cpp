// SPDX-License-Identifier: MIT
#include "film/error_places.h"

#include <gtest/gtest.h>

#include "film/small_films.h"

namespace polhode {
namespace {

Error about(const std::string& key) {
  return input_error("is wrong").at({{}, 0, key});
}

// line 4 of the text has body.solid, line 6 motion.duration
TEST(Placed, AKeyOfTheFileGetsItsLine) {
  const Scene scene = test::small_scene();
  EXPECT_STREQ(placed(scene, about("motion.duration")).what(),
               "scene.toml:6: motion.duration: is wrong");
  EXPECT_EQ(placed(scene, about("body.solid.semi_axes")).place().line, 4);
}

TEST(Placed, AKeyThatIsNotThereGetsTheLineOfItsTable) {
  const Scene scene = test::small_scene();
  EXPECT_STREQ(placed(scene, about("motion.gravity")).what(),
               "scene.toml:5: motion.gravity: is wrong");
  EXPECT_EQ(placed(scene, about("camera.fov")).place().line, 0);
}

TEST(Placed, AValueOfTheCommandLineIsNamedByItsOption) {
  Scene scene = test::small_scene();
  scene.options["video.fps"].key = "--fps";
  const Error error = placed(scene, about("video.fps"));
  EXPECT_STREQ(error.what(), "--fps: is wrong");
  EXPECT_EQ(error.fault(), Fault::input);
  EXPECT_EQ(placed(scene, Error(Fault::check_failed, "no", {{}, 0, "video.fps"})).fault(),
            Fault::check_failed);
}

// a body or motion that was changed there may be what is wrong
TEST(Placed, SettingsOfTheMechanicsAreNamedBesideAnotherKey) {
  Scene scene = test::small_scene();
  scene.options["body.solid.mass"].key = "--set body.solid.mass";
  scene.options["video.size"].key = "--set video.size";
  EXPECT_STREQ(placed(scene, about("motion.duration")).what(),
               "scene.toml:6: motion.duration: is wrong (with --set body.solid.mass)");
  EXPECT_STREQ(placed(scene, about("camera.fov")).what(), "scene.toml: camera.fov: is wrong");
}

TEST(Placed, ErrorsThatKnowTheirFileOrNoKeyStayAsTheyAre) {
  const Scene scene = test::small_scene();
  EXPECT_STREQ(placed(scene, input_error("no GL")).what(), "no GL");
  const Error mesh = input_error("is empty").at({"mesh.obj", 0, "motion.duration"});
  EXPECT_STREQ(placed(scene, mesh).what(), mesh.what());
}

TEST(WithPlace, GivesWhatTheWorkGivesOrItsErrorWithAPlace) {
  const Scene scene = test::small_scene();
  EXPECT_EQ(with_place(scene, [] { return 7; }), 7);
  EXPECT_EQ(
      test::message_of([&] { with_place(scene, []() -> int { throw about("motion.duration"); }); }),
      "scene.toml:6: motion.duration: is wrong");
}

}  // namespace
}  // namespace polhode
