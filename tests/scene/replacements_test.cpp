// SPDX-License-Identifier: MIT
// Numbers put in place of a scene file's own.
#include <gtest/gtest.h>

#include "scene/scene.h"
#include "support/expect_error.h"
#include "support/run.h"

namespace polhode::test {
namespace {

class ReplacedNumbers : public testing::Test {
 protected:
  ReplacedNumbers() : file_(folder_ / "scene.toml") { write_text(file_, kSmallScene); }

  TemporaryFolder folder_;
  std::string file_;
};

TEST_F(ReplacedNumbers, StandWhereTheFilesStood) {
  const Scene scene = load_scene(file_,
                                 {{"motion.spin.body[2]", -7.5},
                                  {"motion.duration", 2.0},
                                  {"body.solid.semi_axes[0]", 0.15},
                                  {"numerics.step", 0.25}});
  EXPECT_EQ(*scene.motion.spin.body, Vec3(1, 0, -7.5));
  EXPECT_EQ(scene.motion.duration, 2.0);
  EXPECT_EQ((*scene.body.solid->semi_axes)[0], 0.15);
  EXPECT_EQ(scene.numerics.step, 0.25);
  EXPECT_EQ(*load_scene(file_).motion.spin.body, Vec3(1, 0, 3));
}

TEST_F(ReplacedNumbers, AreFound) {
  EXPECT_EQ(number_in_scene(file_, "motion.spin.body[2]"), 3.0);
  EXPECT_EQ(number_in_scene(file_, "body.solid.mass"), 1.0);
  for (const char* path : {"motion.spin.body[3]", "motion.spn", "motion.spin", "video.size"})
    EXPECT_FALSE(number_in_scene(file_, path)) << path;
}

// what is no number of the file is refused, by its path or by the strict reader
TEST_F(ReplacedNumbers, WrongPathsAreRefused) {
  const auto with = [&](const char* path, double value = 1.0) {
    return [=, this] {
      load_scene(file_, {{path, value}});
    };
  };
  for (const char* path : {"motion.spin.body[7]", "motion.spin", "video.size[0]", "motion.spin[0]"})
    expect_input_error(with(path), "", "no number at");
  for (const char* path : {"motion.spin.body[", "motion..spin", "motion.spin.body[x]", ""})
    expect_input_error(with(path), "", "no key");
  expect_input_error(with("motion.durration"), "motion.durration", "did you mean 'duration'?");
  expect_input_error(with("motion.duration", -1.0), "motion.duration", "greater than 0");
}

}  // namespace
}  // namespace polhode::test
