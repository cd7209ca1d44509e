// SPDX-License-Identifier: MIT
#include "frame/label_tracks.h"

#include <cmath>

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
    EXPECT_LT((tracks.place("name", kWish, at).center - Vec2(300, 168)).norm(), 1e-9) << at;
}

// a curve under the wished place moves a label beside it; one that is everywhere does not
TEST(LabelTracks, LabelsKeepOffCurves) {
  LabelMoment moment = moment_with({});
  moment.curves = {{Vec2(250, 165), Vec2(350, 165)}};
  const TextRoom wished = room_at(Vec2(300, 168), kWish.width, kWish.height);
  ASSERT_TRUE(is_over(wished, moment.curves.front()));
  const auto room_with = [&](const LabelMoment& one) {
    const LabelTracks tracks(std::vector<LabelMoment>(9, one), kFrame, kGap);
    return room_at(tracks.place("name", kWish, 4.0).center, kWish.width, kWish.height);
  };
  EXPECT_FALSE(is_over(room_with(moment), moment.curves.front()));
  for (double y = 100.0; y < 260.0; y += 8.0)
    moment.curves.push_back({Vec2(250, y), Vec2(350, y)});
  EXPECT_LT((room_with(moment).center() - wished.center()).norm(), 1e-9);
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
  const Vec2 first = tracks.place("name", kWish, 0.0).center;
  EXPECT_GT((first - Vec2(300, 168)).norm(), 10.0);
  for (double at = 0.0; at < 38.0; at += 0.5)
    EXPECT_LT((tracks.place("name", kWish, at).center - first).norm(), 1e-9) << at;
}

// one that must change sides fades before and comes back there
TEST(LabelTracks, LabelsFadeWhereTheyChange) {
  std::vector<LabelMoment> moments;
  for (int k = 0; k < 40; ++k) {
    // a wall on the one side, then on the other
    const TextRoom above{0, 0, 640, 176}, below{0, 184, 640, 360};
    moments.push_back(moment_with({k < 20 ? above : below}));
  }
  const LabelTracks tracks(moments, kFrame, kGap);
  LabelPlace before = tracks.place("name", kWish, 0.0);
  int changes = 0;
  for (double at = 0.0; at < 39.0; at += 0.1) {
    const LabelPlace now = tracks.place("name", kWish, at);
    EXPECT_LT(std::abs(now.opacity - before.opacity), 0.1) << at;
    if ((now.center - before.center).norm() > 1.0) {
      ++changes;
      EXPECT_LT(now.opacity, 0.05) << at;
    }
    before = now;
  }
  EXPECT_EQ(changes, 1);
}

// where no side is free it stands beside what is in its way, and goes with it
TEST(LabelTracks, LabelsGoWithWhatTheyKeepOff) {
  std::vector<LabelMoment> moments;
  for (int k = 0; k < 40; ++k)
    moments.push_back(moment_with({{200.0 + 0.5 * k, 60, 400.0 + 0.5 * k, 300}}));
  const LabelTracks tracks(moments, kFrame, kGap);
  LabelPlace before = tracks.place("name", kWish, 0.0);
  for (double at = 0.0; at < 39.0; at += 0.1) {
    const LabelPlace now = tracks.place("name", kWish, at);
    EXPECT_LT((now.center - before.center).norm(), 1.0) << at;
    EXPECT_EQ(now.opacity, 1.0);
    before = now;
  }
}

}  // namespace
}  // namespace polhode
