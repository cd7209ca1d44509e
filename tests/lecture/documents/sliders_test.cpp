// SPDX-License-Identifier: MIT
#include "lecture/documents/sliders.h"

#include <gtest/gtest.h>

#include "lecture/decks.h"
#include "support/expect_error.h"
#include "support/scenes.h"

namespace polhode {
namespace {

TEST(Sliders, AreWhatTheDeckSays) {
  const std::vector<Slider> sliders =
      parse_sliders("motion.spin.body_rpm[2] 100 8e2  Spin, rpm ; body.solid.mass 0.5 2;");
  ASSERT_EQ(sliders.size(), 2u);
  EXPECT_EQ(sliders[0].key, "motion.spin.body_rpm[2]");
  EXPECT_EQ(sliders[0].from, 100.0);
  EXPECT_EQ(sliders[0].to, 800.0);
  EXPECT_EQ(sliders[0].words, "Spin, rpm");
  EXPECT_EQ(sliders[1].words, "body.solid.mass");
  EXPECT_TRUE(parse_sliders(" ; ").empty());
}

TEST(Sliders, WrongOnesAreToldOfBeforeAnyWork) {
  test::expect_input_error([] { parse_sliders("motion.spin.body_rpm[2] 100"); }, "", "KEY FROM TO");
  test::expect_input_error([] { parse_sliders("a 2 1"); }, "", "must rise");
  test::expect_input_error(
      [] { parse_sliders("a 1 2;b 1 2;c 1 2;d 1 2;e 1 2;f 1 2;g 1 2;h 1 2;i 1 2"); },
      "",
      "at most 8");
  const auto check = [](const char* vary, const char* scene) {
    check_sliders(parse_sliders(vary), test::scene_path(scene), {});
  };
  check("motion.spin.rates_deg_per_s[2] 10 800", "free_symmetric_top");
  test::expect_input_error([&] { check("motion.spin.body[7] 1 2", "free_symmetric_top"); },
                           "",
                           "no number 'motion.spin.body[7]'");
  test::expect_input_error(
      [&] { check("motion.spin.rates_deg_per_s[2] 1 2", "free_symmetric_top"); },
      "",
      "outside of 1 to 2");
  test::expect_input_error(
      [&] { check("video.fps 0 100", "free_symmetric_top"); }, "video.fps = 0", "");
}

}  // namespace
}  // namespace polhode
