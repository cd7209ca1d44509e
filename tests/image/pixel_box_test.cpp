// SPDX-License-Identifier: MIT
#include "image/pixel_box.h"

#include <random>

#include <gtest/gtest.h>

#include "image/random_boxes.h"

namespace polhode {
namespace {

using test::kSide;
using test::random_boxes;

// how many of the boxes hold each pixel
std::vector<int> counted(const std::vector<PixelBox>& boxes) {
  std::vector<int> count(kSide * kSide);
  for (const PixelBox& box : boxes) {
    for (int y = box.y; y < box.bottom(); ++y) {
      for (int x = box.x; x < box.right(); ++x)
        ++count[static_cast<std::size_t>(y * kSide + x)];
    }
  }
  return count;
}

TEST(PixelBox, WhatOneHasAndTheOthersHaveNot) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const PixelBox one = random_boxes(random, 1).front();
    const std::vector<PixelBox> others = random_boxes(random, round % 4);
    const std::vector<int> a = counted({one});
    const std::vector<int> b = counted(others);
    const std::vector<int> rest = counted(without(one, others));
    for (std::size_t i = 0; i < a.size(); ++i)
      ASSERT_EQ(rest[i], a[i] == 1 && b[i] == 0 ? 1 : 0);
  }
}

TEST(PixelBox, BandsCoverAllAndDoNotOverlap) {
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    const int rows = 1 + round % 7;
    const std::vector<PixelBox> boxes = random_boxes(random, 5);
    const std::vector<PixelBox> bands = in_bands(boxes, rows);
    const std::vector<int> before = counted(boxes);
    const std::vector<int> after = counted(bands);
    for (std::size_t i = 0; i < before.size(); ++i) {
      ASSERT_LE(after[i], 1);
      ASSERT_GE(after[i], before[i] > 0 ? 1 : 0);
    }
    for (const PixelBox& band : bands)
      ASSERT_EQ(band.y / rows, (band.bottom() - 1) / rows);
  }
  EXPECT_TRUE(in_bands({}, 8).empty());
}

}  // namespace
}  // namespace polhode
