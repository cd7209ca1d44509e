// SPDX-License-Identifier: MIT
// SSIM, FLIP and the plain metrics against other implementations (reference_metrics.py), against
// published values, and against what their definitions promise.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/compare.h"
#include "image/flip.h"
#include "image/ssim.h"
#include "support/flat_image.h"

namespace polhode {
namespace {

int floor_div(int a, int b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

// the pictures of reference_metrics.py
Image scene(const std::string& kind) {
  constexpr int w = 96, h = 64;
  Image image(w, h);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const int u = kind == "shifted" ? x - 1 : x;
      int rgb[3] = {
          (37 + 3 * u + 2 * y) % 256, (90 + floor_div(u * y, 7)) % 256, (200 - 2 * u + y) % 256};
      const int disc[3] = {230, 180, 40};
      const int dx = u - w / 2, dy = y - h / 2;
      if (dx * dx + dy * dy < (h / 3) * (h / 3)) std::copy_n(disc, 3, rgb);
      if (kind == "tinted") rgb[0] += 4;
      if (kind == "noisy") {
        for (int& value : rgb)
          value += (x * 7 + y * 13) % 5 - 2;
      }
      if (kind == "hole" && std::abs(x - w / 4) < 4 && std::abs(y - h / 4) < 3)
        std::fill_n(rgb, 3, 0);
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<std::uint8_t>(std::clamp(rgb[c], 0, 255));
      image.at(x, y)[3] = 255;
    }
  }
  return image;
}

Image flat(int r, int g, int b, int alpha = 255, int side = 48) {
  return test::flat_image(side, side, r, g, b, alpha);
}

struct Reference {
  const char* kind;
  int largest;
  double mean, rms, psnr, over_3, ssim, flip, worst_flip;
};

// printed by reference_metrics.py: numpy, scikit-image 0.19, and FLIP from its formulas
const Reference kReferences[] = {
    // clang-format off
    {"shifted", 254, 5.100368924, 23.328745364, 20.7729760, 0.461263021, 0.8709196, 0.1758254, 0.790710},
    {"tinted", 4, 1.328016493, 2.303638238, 40.8825180, 0.993652344, 0.9999733, 0.0698505, 0.102816},
    {"noisy", 2, 1.197808160, 1.412716613, 45.1297026, 0.000000000, 0.9870199, 0.0099385, 0.039837},
    {"hole", 176, 0.861165365, 11.454258272, 26.9514642, 0.005696615, 0.9675619, 0.0087416, 0.973055},
    // clang-format on
};

class Metrics : public ::testing::TestWithParam<Reference> {};

TEST_P(Metrics, AgreeWithOtherImplementations) {
  const Reference& wanted = GetParam();
  const Image a = scene("plain"), b = scene(wanted.kind);
  const Difference difference = compare(a, b, 3);
  EXPECT_EQ(difference.values, 3);
  EXPECT_EQ(difference.largest, wanted.largest);
  EXPECT_NEAR(difference.mean, wanted.mean, 1e-9);
  EXPECT_NEAR(difference.rms, wanted.rms, 1e-9);
  EXPECT_NEAR(psnr(difference.rms), wanted.psnr, 1e-6);
  EXPECT_NEAR(difference.fraction_over, wanted.over_3, 1e-9);
  EXPECT_NEAR(ssim(a, b), wanted.ssim, 2e-6);
  const FlipMap map = flip(a, b);
  EXPECT_NEAR(map.mean, wanted.flip, 2e-5);
  EXPECT_NEAR(*std::max_element(map.errors.begin(), map.errors.end()), wanted.worst_flip, 2e-4);
}
INSTANTIATE_TEST_SUITE_P(Pictures, Metrics, ::testing::ValuesIn(kReferences), [](const auto& row) {
  return row.param.kind;
});

TEST(Metrics, EqualPicturesDoNotDiffer) {
  const Image a = scene("plain");
  EXPECT_EQ(compare(a, a, 0).rms, 0.0);
  EXPECT_TRUE(std::isinf(psnr(0.0)));
  EXPECT_EQ(ssim(a, a), 1.0);
  EXPECT_EQ(flip(a, a).mean, 0.0);
}

// the number of threads and of bands changes no bit
TEST(Metrics, DoNotDependOnThreads) {
  Image a(150, 200);
  std::mt19937 random(7);
  for (std::uint8_t& value : a.pixels)
    value = static_cast<std::uint8_t>(random() & 255);
  for (std::size_t i = 3; i < a.pixels.size(); i += 4)
    a.pixels[i] = 255;
  Image b = a;
  b.at(70, 100)[1] = static_cast<std::uint8_t>(b.at(70, 100)[1] ^ 0x80);
  EXPECT_EQ(ssim(a, b, 1), ssim(a, b, 4));
  EXPECT_EQ(flip(a, b, kPixelsPerDegree, 1).errors, flip(a, b, kPixelsPerDegree, 4).errors);
  EXPECT_EQ(flip(a, b, kPixelsPerDegree, 1).mean, flip(a, b, kPixelsPerDegree, 4).mean);
  // far from the pixel nothing differs, near it something does
  const FlipMap map = flip(a, b);
  EXPECT_EQ(map.errors[0], 0.0F);
  EXPECT_GT(map.errors[100 * 150 + 70], 0.01F);
}

// Wang 2004, eq. 6 and 13: where contrast and structure are the same, means alone count
TEST(Ssim, OfFlatPicturesComparesTheirMeans) {
  const double c1 = 0.01 * 255 * 0.01 * 255;
  EXPECT_NEAR(ssim(flat(0, 0, 0), flat(255, 255, 255)), c1 / (255.0 * 255.0 + c1), 1e-6);
  EXPECT_NEAR(ssim(flat(100, 100, 100), flat(150, 150, 150)),
              (2.0 * 100 * 150 + c1) / (100.0 * 100 + 150.0 * 150 + c1),
              1e-6);
}

TEST(Ssim, TakesPicturesSmallerThanItsWindow) {
  const double c1 = 0.01 * 255 * 0.01 * 255;
  EXPECT_NEAR(
      ssim(flat(0, 0, 0, 255, 1), flat(255, 255, 255, 255, 1)), c1 / (255.0 * 255.0 + c1), 1e-6);
}

// the paper's own anchors: green against blue is the largest error there is
TEST(Flip, OfFlatPictures) {
  EXPECT_NEAR(flip(flat(0, 255, 0), flat(0, 0, 255)).mean, 1.0, 1e-5);
  EXPECT_NEAR(flip(flat(0, 0, 0), flat(255, 255, 255)).mean, 0.9673798, 1e-5);
  EXPECT_NEAR(flip(flat(100, 100, 100), flat(104, 104, 104)).mean, 0.0810911, 5e-5);
}

TEST(Flip, IsSymmetricAndShownInMagma) {
  const Image a = scene("plain"), b = scene("shifted");
  const FlipMap there = flip(a, b), back = flip(b, a);
  EXPECT_NEAR(there.mean, back.mean, 1e-6);
  const Image black = heat_picture(flip(a, a));
  EXPECT_EQ(black.at(5, 5)[0], 0);
  EXPECT_EQ(black.at(5, 5)[2], 4);
  const Image hot = heat_picture(flip(flat(0, 255, 0), flat(0, 0, 255)));
  EXPECT_EQ(hot.at(20, 20)[0], 252);
  EXPECT_EQ(hot.at(20, 20)[1], 253);
  EXPECT_EQ(hot.at(20, 20)[2], 191);
}

// seen from further away a pixel counts for less
TEST(Flip, FallsWithDistance) {
  const Image a = scene("plain"), b = scene("noisy");
  EXPECT_GT(flip(a, b, 30.0).mean, flip(a, b, 60.0).mean);
}

TEST(Transparent, WhatCannotBeSeenDoesNotDiffer) {
  const Image clear_red = flat(255, 0, 0, 0), clear_blue = flat(0, 0, 255, 0);
  EXPECT_EQ(compare(clear_red, clear_blue, 0).largest, 0);
  EXPECT_EQ(compare(clear_red, clear_blue, 0).values, 4);
  EXPECT_EQ(ssim(clear_red, clear_blue), 1.0);
  EXPECT_EQ(flip(clear_red, clear_blue).mean, 0.0);
}

TEST(Transparent, AlphaAloneIsADifference) {
  // black and half black are one on black, but not on white
  const Image black = flat(0, 0, 0), half = flat(0, 0, 0, 128);
  const Difference difference = compare(black, half, 3);
  EXPECT_EQ(difference.largest, 127);
  EXPECT_EQ(difference.values, 4);
  EXPECT_DOUBLE_EQ(difference.mean, 127.0 / 4.0);
  EXPECT_EQ(difference.fraction_over, 1.0);
  EXPECT_LT(ssim(black, half), 0.1);
  EXPECT_GT(flip(black, half).mean, 0.5);
  EXPECT_EQ(difference_picture(black, half, 2).at(3, 3)[0], 254);
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

TEST(Metrics, DifferentSizesCannotBeCompared) {
  EXPECT_THROW(ssim(flat(0, 0, 0, 255, 20), flat(0, 0, 0, 255, 21)), Error);
  EXPECT_THROW(flip(flat(0, 0, 0, 255, 20), flat(0, 0, 0, 255, 21)), Error);
}

}  // namespace
}  // namespace polhode
