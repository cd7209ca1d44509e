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

}  // namespace
}  // namespace polhode
