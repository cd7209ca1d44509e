// SPDX-License-Identifier: MIT
#include "image/ssim.h"

#include "support/expect_error.h"
#include "support/metric_references.h"

namespace polhode::test {
namespace {

class SsimReferences : public ::testing::TestWithParam<Reference> {};
INSTANTIATE_TEST_SUITE_P(Pictures, SsimReferences, references(), reference_name);

TEST_P(SsimReferences, AgreeWithOtherImplementations) {
  EXPECT_NEAR(ssim(scene("plain"), scene(GetParam().kind)), GetParam().ssim, 2e-6);
}

TEST(Ssim, IsOneForEqualPictures) {
  EXPECT_EQ(ssim(scene("plain"), scene("plain")), 1.0);
}

// the number of threads and of bands changes no bit
TEST(Ssim, DoesNotDependOnThreads) {
  const auto [a, b] = noise_with_one_change();
  EXPECT_EQ(ssim(a, b, 1), ssim(a, b, 4));
  EXPECT_LT(ssim(a, b), 1.0);
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

TEST(Ssim, WhatCannotBeSeenDoesNotDiffer) {
  EXPECT_EQ(ssim(flat(255, 0, 0, 0), flat(0, 0, 255, 0)), 1.0);
}

TEST(Ssim, AlphaAloneIsADifference) {
  // black and half black are one on black, but not on white
  EXPECT_LT(ssim(flat(0, 0, 0), flat(0, 0, 0, 128)), 0.1);
}

TEST(Ssim, DifferentSizesCannotBeCompared) {
  expect_input_error([] { ssim(flat(0, 0, 0, 255, 20), flat(0, 0, 0, 255, 21)); },
                     "",
                     "different sizes: 20x20 and 21x21");
}

}  // namespace
}  // namespace polhode::test
