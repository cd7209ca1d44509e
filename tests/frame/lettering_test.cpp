// SPDX-License-Identifier: MIT
#include "frame/lettering.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Lettering, TextIsSetSmallerOnlyWhereItMust) {
  const Typesetter typesetter;
  const TextStyle wanted = style_of(make_theme({}), 40.0, glm::vec3(1.0f));
  const std::string words = "Explicit Euler, |L| put right";
  for (const double width : {100.0, 300.0, 500.0, 1000.0}) {
    for (const double height : {50.0, 105.0, 300.0}) {
      const TextStyle style = fitted(typesetter, words, wanted, width, height);
      const TextBox box = typesetter.measure(words, style);
      EXPECT_LE(box.width, width) << height;
      EXPECT_LE(box.height, height) << width;
      EXPECT_NEAR(style.halo / style.size, wanted.halo / wanted.size, 1e-9);
      if (width == 1000.0) {
        EXPECT_EQ(style.size, wanted.size);
        EXPECT_EQ(style.width, 0.0) << "in one line";
      }
    }
  }
  // two lines are better than small letters
  EXPECT_EQ(fitted(typesetter, words, wanted, 400.0, 105.0).size, wanted.size);
}

TEST(Lettering, TypeOfNarrowPanelsIsThatOfTheirArea) {
  EXPECT_EQ(type_size(1920, 1080), 1080.0);
  EXPECT_NEAR(type_size(640, 1080), 623.5, 0.1);
  EXPECT_EQ(type_size(4000, 100), 100.0);
}

}  // namespace
}  // namespace polhode
