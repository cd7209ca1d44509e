// SPDX-License-Identifier: MIT
#include "frame/label_tracks.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

constexpr double kGap = 4.0;
const TextRoom kFrame{0, 0, 640, 360};
const LabelWish kWish{Vec2(300, 180), Vec2(0, -1), 20, 16};

LabelMoment moment_with(const std::vector<TextRoom>& marks) {
  return {{"name"}, {kWish}, {{Vec2(300, 300), kWish.at}}, {{}, marks}};
}

TEST(LabelTracks, AFreeLabelStandsWhereItWishes) {
  const LabelTracks tracks(std::vector<LabelMoment>(9, moment_with({})), kFrame, kGap);
  for (const double at : {0.0, 2.3, 8.0})
    EXPECT_LT((tracks.center("name", kWish, at) - Vec2(300, 168)).norm(), 1e-9) << at;
}

// a head that comes and goes where a label wishes to stand moves it once, not each time
TEST(LabelTracks, LabelsDoNotGoToAndFro) {
  std::vector<LabelMoment> moments;
  for (int k = 0; k < 40; ++k) {
    const TextRoom head{290, 160, 310, 175};
    moments.push_back(
        moment_with(k % 4 < 2 ? std::vector<TextRoom>{head} : std::vector<TextRoom>{}));
  }
  const LabelTracks tracks(moments, kFrame, kGap);
  const Vec2 first = tracks.center("name", kWish, 0.0);
  EXPECT_GT((first - Vec2(300, 168)).norm(), 10.0);
  for (double at = 0.0; at < 38.0; at += 0.5)
    EXPECT_LT((tracks.center("name", kWish, at) - first).norm(), 1e-9) << at;
}

// one that must change sides glides there
TEST(LabelTracks, LabelsGlide) {
  std::vector<LabelMoment> moments;
  for (int k = 0; k < 40; ++k) {
    const TextRoom above{280, 140, 320, 176}, below{270, 184, 330, 300};
    const TextRoom right{304, 140, 360, 300};
    moments.push_back(moment_with(k < 20 ? std::vector<TextRoom>{above, below}
                                         : std::vector<TextRoom>{above, right}));
  }
  const LabelTracks tracks(moments, kFrame, kGap);
  Vec2 before = tracks.center("name", kWish, 0.0);
  for (double at = 0.0; at < 39.0; at += 0.1) {
    const Vec2 now = tracks.center("name", kWish, at);
    EXPECT_LT((now - before).norm(), 5.0) << at;
    before = now;
  }
}

}  // namespace
}  // namespace polhode
