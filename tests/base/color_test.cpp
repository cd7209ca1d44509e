// SPDX-License-Identifier: MIT
#include "base/color.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace polhode {
namespace {

TEST(ParseColor, GivesThreeBytes) {
  EXPECT_EQ(parse_color("#000000"), (std::array<std::uint8_t, 3>{0, 0, 0}));
  EXPECT_EQ(parse_color("#ff8001"), (std::array<std::uint8_t, 3>{255, 128, 1}));
  EXPECT_EQ(parse_color("#aBcDeF"), (std::array<std::uint8_t, 3>{0xab, 0xcd, 0xef}));
}

TEST(ParseColor, RefusesEverythingElse) {
  for (const char* text :
       {"", "#", "#fff", "#1234567", "1234567", "#12345g", "#-12345", "# 12345", "black"}) {
    EXPECT_THROW(parse_color(text), Error) << text;
  }
}

// 18 % grey is about 46 % of the way to white
TEST(LinearOfSrgb, IsTheStandards) {
  EXPECT_EQ(linear_of_srgb(0.0), 0.0);
  EXPECT_NEAR(linear_of_srgb(1.0), 1.0, 1e-15);
  EXPECT_NEAR(linear_of_srgb(0.04), 0.04 / 12.92, 1e-15);
  EXPECT_NEAR(linear_of_srgb(0.4614), 0.18, 1e-4);
}

}  // namespace
}  // namespace polhode
