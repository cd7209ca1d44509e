// SPDX-License-Identifier: MIT
#include "image/flip.h"

#include <algorithm>

#include "support/expect_error.h"
#include "support/metric_references.h"

namespace polhode::test {
namespace {

class FlipReferences : public ::testing::TestWithParam<Reference> {};
INSTANTIATE_TEST_SUITE_P(Pictures, FlipReferences, references(), reference_name);

TEST_P(FlipReferences, AgreeWithOtherImplementations) {
  const FlipMap map = flip(scene("plain"), scene(GetParam().kind));
  EXPECT_NEAR(map.mean, GetParam().flip, 2e-5);
  EXPECT_NEAR(*std::max_element(map.errors.begin(), map.errors.end()), GetParam().worst_flip, 2e-4);
}

TEST(Flip, IsZeroForEqualPictures) {
  EXPECT_EQ(flip(scene("plain"), scene("plain")).mean, 0.0);
}

// the number of threads and of bands changes no bit
TEST(Flip, DoesNotDependOnThreads) {
  const auto [a, b] = noise_with_one_change();
  EXPECT_EQ(flip(a, b, kPixelsPerDegree, 1).errors, flip(a, b, kPixelsPerDegree, 4).errors);
  EXPECT_EQ(flip(a, b, kPixelsPerDegree, 1).mean, flip(a, b, kPixelsPerDegree, 4).mean);
}

// far from the pixel nothing differs, near it something does
TEST(Flip, LiesWhereTheDifferenceIs) {
  const auto [a, b] = noise_with_one_change();
  const FlipMap map = flip(a, b);
  EXPECT_EQ(map.errors[0], 0.0F);
  EXPECT_GT(map.errors[100 * 150 + 70], 0.01F);
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

TEST(Flip, WhatCannotBeSeenDoesNotDiffer) {
  EXPECT_EQ(flip(flat(255, 0, 0, 0), flat(0, 0, 255, 0)).mean, 0.0);
}

TEST(Flip, AlphaAloneIsADifference) {
  // black and half black are one on black, but not on white
  EXPECT_GT(flip(flat(0, 0, 0), flat(0, 0, 0, 128)).mean, 0.5);
}

TEST(Flip, DifferentSizesCannotBeCompared) {
  expect_input_error([] { flip(flat(0, 0, 0, 255, 20), flat(0, 0, 0, 255, 21)); },
                     "",
                     "different sizes: 20x20 and 21x21");
}

}  // namespace
}  // namespace polhode::test
