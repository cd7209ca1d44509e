// SPDX-License-Identifier: MIT
#include "image/compare.h"

#include <cmath>
#include <random>

#include "base/error.h"
#include "support/metric_references.h"

namespace polhode::test {
namespace {

Image noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image image(width, height);
  for (std::uint8_t& value : image.pixels)
    value = static_cast<std::uint8_t>(random() & 255);
  return image;
}

class CompareReferences : public ::testing::TestWithParam<Reference> {};
INSTANTIATE_TEST_SUITE_P(Pictures, CompareReferences, references(), reference_name);

TEST_P(CompareReferences, AgreeWithOtherImplementations) {
  const Reference& wanted = GetParam();
  const Difference difference = compare(scene("plain"), scene(wanted.kind), 3);
  EXPECT_EQ(difference.values, 3);
  EXPECT_EQ(difference.largest, wanted.largest);
  EXPECT_NEAR(difference.mean, wanted.mean, 1e-9);
  EXPECT_NEAR(difference.rms, wanted.rms, 1e-9);
  EXPECT_NEAR(psnr(difference.rms), wanted.psnr, 1e-6);
  EXPECT_NEAR(difference.fraction_over, wanted.over_3, 1e-9);
}

TEST(Compare, EqualPicturesDoNotDiffer) {
  const Image a = scene("plain");
  EXPECT_EQ(compare(a, a, 0).rms, 0.0);
  EXPECT_TRUE(std::isinf(psnr(0.0)));
}

TEST(Compare, FindsTheOnePixelThatDiffers) {
  Image a = noise(16, 8, 5);
  for (std::size_t i = 3; i < a.pixels.size(); i += 4)
    a.pixels[i] = 255;
  Image b = a;
  EXPECT_EQ(compare(a, b, 0).largest, 0);
  EXPECT_EQ(compare(a, b, 0).fraction_over, 0.0);
  b.at(3, 4)[1] = static_cast<std::uint8_t>(b.at(3, 4)[1] ^ 0x40);
  const Difference difference = compare(a, b, 10);
  EXPECT_EQ(difference.largest, 0x40);
  EXPECT_DOUBLE_EQ(difference.fraction_over, 1.0 / (16 * 8));
  EXPECT_DOUBLE_EQ(difference.mean, 64.0 / (16 * 8 * 3));
  EXPECT_EQ(compare(a, b, 64).fraction_over, 0.0) << "the threshold itself is allowed";
  EXPECT_EQ(difference_picture(a, b, 2).at(3, 4)[1], 128);
  EXPECT_EQ(difference_picture(a, b, 2).at(2, 4)[1], 0);
}

TEST(Compare, RmsIsTheRootOfTheMeanSquare) {
  Image a(2, 1), b(2, 1);
  a.pixels = {0, 0, 0, 255, 0, 0, 0, 255};
  b.pixels = {3, 0, 0, 255, 0, 4, 0, 255};
  EXPECT_DOUBLE_EQ(compare(a, b, 0).rms, std::sqrt(25.0 / 6.0));
}

TEST(Compare, WhatCannotBeSeenDoesNotDiffer) {
  const Image clear_red = flat(255, 0, 0, 0), clear_blue = flat(0, 0, 255, 0);
  EXPECT_EQ(compare(clear_red, clear_blue, 0).largest, 0);
  EXPECT_EQ(compare(clear_red, clear_blue, 0).values, 4);
}

TEST(Compare, AlphaAloneIsADifference) {
  const Image black = flat(0, 0, 0), half = flat(0, 0, 0, 128);
  const Difference difference = compare(black, half, 3);
  EXPECT_EQ(difference.largest, 127);
  EXPECT_EQ(difference.values, 4);
  EXPECT_DOUBLE_EQ(difference.mean, 127.0 / 4.0);
  EXPECT_EQ(difference.fraction_over, 1.0);
  EXPECT_EQ(difference_picture(black, half, 2).at(3, 3)[0], 254);
}

TEST(Compare, DifferentSizesCannotBeCompared) {
  EXPECT_THROW(compare(noise(4, 4, 1), noise(4, 5, 1), 0), Error);
}

TEST(WorstRegion, LiesWhereTheDifferenceIs) {
  const Image a = scene("plain");
  Image b = a;
  b.at(80, 50)[0] = static_cast<std::uint8_t>(b.at(80, 50)[0] ^ 0x80);
  const PixelBox region = worst_region(a, b, 32, 16);
  EXPECT_EQ(region.width, 32);
  EXPECT_EQ(region.height, 16);
  EXPECT_LE(region.x, 80);
  EXPECT_GT(region.x + region.width, 80);
  EXPECT_LE(region.y, 50);
  EXPECT_GT(region.y + region.height, 50);
  EXPECT_EQ(cut_out(a, region).pixels.size(), 4U * 32 * 16);
  EXPECT_EQ(worst_region(flat(0, 0, 0, 255, 5), flat(9, 9, 9, 255, 5), 32, 16).width, 5);
}

TEST(LaidOn, MixesWithTheBackgroundByAlpha) {
  const Image half = flat(200, 100, 0, 128);
  EXPECT_FALSE(is_opaque(half));
  for (const int grey : {0, 255}) {
    const Image laid = laid_on(half, static_cast<std::uint8_t>(grey));
    EXPECT_TRUE(is_opaque(laid));
    for (int c = 0; c < 3; ++c) {
      const double alpha = 128.0 / 255.0;
      EXPECT_NEAR(laid.at(7, 7)[c], alpha * half.at(7, 7)[c] + (1.0 - alpha) * grey, 1.0);
    }
  }
  // what it was painted on has another colour now
  Image painted;
  painted.wipe(8, 8, {200, 100, 0, 0});
  painted.painted.push_back({0, 0, 2, 2});
  EXPECT_FALSE(laid_on(painted, 255).ground);
  EXPECT_TRUE(laid_on(painted, 255).painted.empty());
  Image one_hole = flat(1, 2, 3);
  EXPECT_TRUE(is_opaque(one_hole));
  one_hole.at(47, 47)[3] = 254;
  EXPECT_FALSE(is_opaque(one_hole));
}

}  // namespace
}  // namespace polhode::test
