// SPDX-License-Identifier: MIT
#include <filesystem>

#include <gtest/gtest.h>

#include "golden/cases.h"
#include "image/compare.h"
#include "image/png.h"
#include "support/run.h"

namespace polhode {
namespace {

bool same(const Image& actual, const Image& wanted) {
  const Difference difference = compare(actual, wanted, golden::kThreshold);
  return difference.fraction_over <= golden::kFraction && difference.largest <= golden::kLimit;
}

class Golden : public ::testing::TestWithParam<golden::Case> {};

TEST_P(Golden, LooksAsItDid) {
  const golden::Case& one = GetParam();
  const test::TemporaryFolder folder;
  golden::render(one, folder / "actual.png");
  const Image actual = read_png(folder / "actual.png");
  const Image wanted = read_png(golden::reference(one));
  ASSERT_EQ(actual.width, wanted.width);
  ASSERT_EQ(actual.height, wanted.height);
  if (same(actual, wanted)) return;

  // a failure leaves the picture and its difference for a person, and never touches the reference
  const std::filesystem::path shown = POLHODE_SOURCE_DIR "/output/golden";
  std::filesystem::create_directories(shown);
  write_png(shown / (one.name + ".actual.png"), actual, false);
  write_png(shown / (one.name + ".difference.png"), difference_picture(actual, wanted, 16), false);
  const Difference difference = compare(actual, wanted, golden::kThreshold);
  FAIL() << "largest " << difference.largest << " (limit " << golden::kLimit << "), share over "
         << golden::kThreshold << " levels " << difference.fraction_over << " (allowed "
         << golden::kFraction << "); see " << shown
         << "; if the new picture is right: cmake --build --preset golden-update";
}
INSTANTIATE_TEST_SUITE_P(Pictures,
                         Golden,
                         ::testing::ValuesIn(golden::cases()),
                         [](const auto& row) { return row.param.name; });

// the net holds: what must fail fails, what must pass passes
TEST(GoldenNet, CatchesAShiftAndAColourAndLetsNoiseThrough) {
  const Image wanted = read_png(golden::reference(golden::cases().front()));
  Image shifted = wanted;
  for (int y = 0; y < wanted.height; ++y) {
    for (int x = 1; x < wanted.width; ++x)
      std::copy_n(wanted.at(x - 1, y), 4, shifted.at(x, y));
  }
  EXPECT_FALSE(same(shifted, wanted));
  Image tinted = wanted;
  for (std::size_t i = 0; i < tinted.pixels.size(); i += 4) {
    tinted.pixels[i] = static_cast<std::uint8_t>(std::min(255, tinted.pixels[i] + 4));
  }
  EXPECT_FALSE(same(tinted, wanted));
  Image noisy = wanted;
  for (std::size_t i = 0; i < noisy.pixels.size(); i += 3) {
    noisy.pixels[i] = static_cast<std::uint8_t>(noisy.pixels[i] < 255 ? noisy.pixels[i] + 1 : 254);
  }
  EXPECT_TRUE(same(noisy, wanted));
}

}  // namespace
}  // namespace polhode
