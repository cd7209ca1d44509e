// SPDX-License-Identifier: MIT
#include "image/average.h"

#include <cmath>

#include <gtest/gtest.h>

namespace polhode {
namespace {

Image one(std::uint8_t value, std::uint8_t alpha = 255) {
  Image image(1, 1);
  for (std::size_t i = 0; i < 3; ++i)
    image.pixels[i] = value;
  image.pixels[3] = alpha;
  return image;
}

TEST(Average, IsOfLight) {
  AveragePicture average;
  Image mean;
  for (int i = 0; i < 7; ++i)
    average.add(one(93));
  average.mean(mean);
  EXPECT_EQ(mean.pixels[0], 93);
  // black and white half the time each: half the light, not half the stored value
  average.add(one(0));
  average.add(one(255));
  average.mean(mean);
  EXPECT_EQ(mean.pixels[0], std::lround(255.0 * std::sqrt(0.5)));
  EXPECT_EQ(mean.pixels[3], 255);
}

TEST(Average, TransparentMomentsHaveNoColour) {
  AveragePicture average;
  Image mean;
  average.add(one(200, 255));
  average.add(one(0, 0));
  average.mean(mean);
  EXPECT_EQ(mean.pixels[0], 200);
  EXPECT_EQ(mean.pixels[3], 128);
}

}  // namespace
}  // namespace polhode
