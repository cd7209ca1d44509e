// SPDX-License-Identifier: MIT
#include "image/image.h"

#include <random>

#include <gtest/gtest.h>

#include "image/random_boxes.h"
#include "support/flat_image.h"

namespace polhode {
namespace {

using test::kSide;
using test::random_boxes;

TEST(Image, HasItsRowsFromTopToBottomWithoutGaps) {
  Image image(3, 2);
  EXPECT_EQ(image.pixels.size(), 4U * 3 * 2);
  EXPECT_EQ(image.at(2, 1) - image.at(0, 0), 4 * (3 + 2));
}

TEST(Image, FillsABoxAndNothingElse) {
  Image image = test::flat_image(5, 4, 9, 9, 9);
  image.fill({1, 2, 3, 2}, {1, 2, 3, 4});
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) {
      const bool inside = x >= 1 && x < 4 && y >= 2;
      EXPECT_EQ(image.at(x, y)[0], inside ? 1 : 9) << x << " " << y;
      EXPECT_EQ(image.at(x, y)[3], inside ? 4 : 255) << x << " " << y;
    }
  }
  const Image before = image;
  image.fill({5, 4, 0, 0}, {0, 0, 0, 0});
  EXPECT_EQ(image.pixels, before.pixels);
}

TEST(Image, AWipeMayChangeItsSizeAndItsGround) {
  Image image;
  image.wipe(4, 3, {1, 1, 1, 255});
  image.painted = {{0, 0, 1, 1}};
  image.wipe(2, 5, {2, 2, 2, 255});
  EXPECT_EQ(image.pixels, test::flat_image(2, 5, 2, 2, 2).pixels);
  EXPECT_TRUE(image.painted.empty());
  image.wipe(2, 5, {3, 3, 3, 255});
  EXPECT_EQ(image.pixels, test::flat_image(2, 5, 3, 3, 3).pixels);
}

// a picture that is used again is wiped as a new one, but where it will be painted over
TEST(Image, AWipeLeavesNothingOfThePictureBefore) {
  constexpr std::array<std::uint8_t, 4> kGround = {1, 2, 3, 255};
  Image plain;
  plain.wipe(kSide, kSide, kGround);
  std::mt19937 random(3);
  Image used;
  for (int round = 0; round < 50; ++round) {
    const std::vector<PixelBox> kept = random_boxes(random, round % 4);
    used.wipe(kSide, kSide, kGround, kept);
    for (const PixelBox& box : kept)
      used.fill(box, kGround);
    ASSERT_EQ(used.pixels, plain.pixels);
    for (const PixelBox& box : random_boxes(random, 3)) {
      used.fill(box, {200, static_cast<std::uint8_t>(round), 9, 255});
      used.painted.push_back(box);
    }
  }
}

}  // namespace
}  // namespace polhode
