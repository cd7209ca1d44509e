// SPDX-License-Identifier: MIT
#include "image/shrink.h"

#include <gtest/gtest.h>

namespace polhode::test {
namespace {

TEST(Shrink, EveryPixelIsTheMeanOfItsSquare) {
  Image large(6, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 6; ++x) {
      for (int c = 0; c < 4; ++c)
        large.at(x, y)[c] = static_cast<std::uint8_t>(10 * x + 7 * y + c);
    }
  }
  const Image small = shrunk(large, 2);
  ASSERT_EQ(small.width, 3);
  ASSERT_EQ(small.height, 2);
  // columns 2x, 2x+1 and rows 2y, 2y+1: 10 (2x + 1/2) + 7 (2y + 1/2) + c, and a half goes up
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      for (int c = 0; c < 4; ++c)
        EXPECT_EQ(small.at(x, y)[c], 20 * x + 14 * y + c + 9);
    }
  }
  EXPECT_EQ(shrunk(large, 1).pixels, large.pixels);
}

}  // namespace
}  // namespace polhode::test
