// SPDX-License-Identifier: MIT
#include "app/compare/frame_score.h"

#include <cmath>

#include <gtest/gtest.h>

namespace polhode {
namespace {

FrameScore score(int largest, double mean, double rms, double over, double badness) {
  FrameScore one;
  one.values = {largest, mean, rms, over, 3};
  one.badness = badness;
  if (badness > 1.0) one.reason = "too different";
  return one;
}

TEST(FrameName, IsTheTimeInAFilmAndTheLabelElsewhere) {
  FrameScore one;
  one.index = 12;
  one.time = 0.2;
  EXPECT_EQ(frame_name(one, true), "frame 12 (0.2000 s)");
  EXPECT_EQ(frame_name(one, false), "");
  one.label = "a.png";
  EXPECT_EQ(frame_name(one, false), "picture 'a.png'");
  EXPECT_EQ(frame_name(one, true), "frame 12 (0.2000 s)");
}

// frames are equally large, so the mean of all values is the mean of the frames' means
TEST(Summarise, TakesExtremesMeansAndTheRmsOfAllValues) {
  const DiffSummary summary = summarise(
      {score(9, 1.0, 3.0, 0.1, 0.5), score(40, 2.0, 4.0, 0.2, 1.5), score(7, 6.0, 12.0, 0.0, 1.2)});
  EXPECT_EQ(summary.values.largest, 40);
  EXPECT_DOUBLE_EQ(summary.values.mean, 3.0);
  EXPECT_DOUBLE_EQ(summary.values.rms, std::sqrt((9.0 + 16.0 + 144.0) / 3.0));
  EXPECT_DOUBLE_EQ(summary.values.fraction_over, 0.1);
  EXPECT_EQ(summary.values.values, 3);
  EXPECT_EQ(summary.different, 2);
  EXPECT_EQ(summary.worst, 1U);
  EXPECT_FALSE(summary.ssim);
  EXPECT_FALSE(summary.flip);
}

TEST(Summarise, TakesTheWorstOfEachMeasure) {
  std::vector<FrameScore> scores(3);
  scores[0].ssim = 0.9;
  scores[1].ssim = -0.2;
  scores[1].flip = 0.3;
  scores[2].flip = 0.1;
  scores[2].values.values = 4;
  const DiffSummary summary = summarise(scores);
  EXPECT_EQ(summary.ssim, -0.2);
  EXPECT_EQ(summary.flip, 0.3);
  EXPECT_EQ(summary.values.values, 4) << "one frame has alpha";
  EXPECT_EQ(summary.different, 0);
  EXPECT_EQ(summary.worst, 0U) << "the first of equals";
}

}  // namespace
}  // namespace polhode
