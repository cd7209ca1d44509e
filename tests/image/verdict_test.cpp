// SPDX-License-Identifier: MIT
// The rule of three numbers, each number by itself.
#include "image/verdict.h"

#include "support/expect_error.h"

namespace polhode {
namespace {

// 100x100, grey; the first `count` pixels differ by `levels`
std::pair<Image, Image> pair_with(int count, int levels) {
  Image a(100, 100);
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    a.pixels[i] = i % 4 == 3 ? 255 : 100;
  Image b = a;
  for (int i = 0; i < count; ++i)
    b.pixels[4 * static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(100 + levels);
  return {a, b};
}

std::string reason(int count, int levels, const Thresholds& thresholds = {}) {
  const auto [a, b] = pair_with(count, levels);
  const Verdict verdict = judge(a, b, thresholds);
  EXPECT_EQ(verdict.same(), badness(verdict, thresholds) <= 1.0) << verdict.reason;
  return verdict.reason;
}

TEST(Verdict, ThreeNumbers) {
  EXPECT_EQ(reason(0, 0), "");
  EXPECT_EQ(reason(10'000, 3), "") << "up to max is no difference";
  EXPECT_EQ(reason(5, 70), "") << "the share itself is allowed, and the limit itself";
  EXPECT_NE(reason(6, 4).find("0.06% of the pixels"), std::string::npos);
  EXPECT_NE(reason(1, 71).find("71 levels"), std::string::npos);
  EXPECT_EQ(reason(10'000, 40, {40, 0.0, 70}), "");
  EXPECT_EQ(reason(10'000, 41, {40, 1.0, 70}), "");
  EXPECT_NE(reason(1, 1, {0, 0.0, 0}), "") << "0, 0, 0: equal to the bit";
  EXPECT_EQ(reason(10'000, 80, {90, 0.0, 70}), "") << "a limit below max limits nothing";
}

TEST(Verdict, SsimAndFlipCountWhenAsked) {
  const auto [a, b] = pair_with(5, 60);
  Thresholds thresholds;
  EXPECT_FALSE(judge(a, b, thresholds).ssim);
  EXPECT_FALSE(judge(a, b, thresholds).flip);
  EXPECT_TRUE(judge(a, b, thresholds, {true, true}).ssim);
  EXPECT_TRUE(judge(a, b, thresholds, {true, true}).flip);
  thresholds.ssim = 0.9999999;
  EXPECT_NE(judge(a, b, thresholds).reason.find("SSIM"), std::string::npos);
  EXPECT_GT(badness(judge(a, b, thresholds), thresholds), 1.0);
  thresholds.ssim.reset();
  thresholds.flip = 0.0;
  EXPECT_NE(judge(a, b, thresholds).reason.find("FLIP"), std::string::npos);
}

TEST(Verdict, ThresholdsHaveRanges) {
  const auto with = [](const Thresholds& t) {
    return [t] {
      check_thresholds(t);
    };
  };
  test::expect_input_error(with({-1, 0.0, 0}), "--max", "0 to 255");
  test::expect_input_error(with({0, 1.5, 0}), "--fraction", "0 to 1");
  test::expect_input_error(with({0, 0.0, 256}), "--limit", "0 to 255");
  test::expect_input_error(with({0, 0.0, 0, 2.0}), "--ssim", "-1 to 1");
  test::expect_input_error(with({0, 0.0, 0, {}, -0.1}), "--flip", "0 to 1");
}

}  // namespace
}  // namespace polhode
