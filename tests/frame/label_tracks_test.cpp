// SPDX-License-Identifier: MIT
#include "frame/label_tracks.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"

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

// a vector beside the tip, on the wished side, has the name on the near side of it
TEST(LabelTracks, NoOtherVectorPartsANameFromItsTip) {
  LabelMoment moment = moment_with({});
  moment.names = {"name", "other"};
  moment.wishes.push_back({Vec2(500, 176), Vec2(1, 0), 20, 16});
  moment.shafts.push_back({Vec2(200, 176), Vec2(500, 176)});
  const LabelTracks tracks(std::vector<LabelMoment>(9, moment), kFrame, kGap);
  EXPECT_GT(tracks.place("name", kWish, 4.0).center.y(), 176.0);
}

// Two vectors that end at one height have names that are not read as one word; one above the other
// is as near as any.
TEST(LabelTracks, NamesBesideEachOtherAreApart) {
  for (double apart = 0.0; apart <= 40.0; apart += 2.0) {
    const LabelWish right{kWish.at + Vec2(apart, 0), kWish.away, 20, 16};
    const LabelMoment moment{{"left", "right"},
                             {kWish, right},
                             {{Vec2(300, 300), kWish.at}, {Vec2(300, 300), right.at}},
                             {}};
    const LabelTracks tracks(std::vector<LabelMoment>(9, moment), kFrame, kGap);
    const Vec2 between =
        tracks.place("right", right, 4.0).center - tracks.place("left", kWish, 4.0).center;
    const double across = std::abs(between.x()) - kWish.width;
    const double along = std::abs(between.y()) - kWish.height;
    EXPECT_TRUE(across >= 0.6 * kWish.height || along >= 0.0) << apart << ' ' << across;
  }
}

// a longer vector on the right of the tip: the name stands on the left, beside its own
TEST(LabelTracks, NamesAreNearestToTheirOwnVectors) {
  LabelMoment moment = moment_with({});
  moment.names = {"name", "other"};
  const Vec2 tip(304, 90);
  moment.wishes.push_back({tip, Vec2(0, -1), 20, 16});
  moment.shafts.push_back({Vec2(304, 300), tip});
  const LabelTracks tracks(std::vector<LabelMoment>(9, moment), kFrame, kGap);
  const TextRoom room = room_at(tracks.place("name", kWish, 4.0).center, kWish.width, kWish.height);
  EXPECT_LT(room.right, kWish.at.x());
  EXPECT_LT(distance(room, kWish.at), 304.0 - room.right);
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

// around an ellipse that turns: beside it and off the body, always as near, and without a jump
TEST(LabelTracks, NamesOfCirclesStandAroundThem) {
  const auto wish_at = [](double k) {
    LabelWish wish = kWish;
    wish.half_a = 80.0 * Vec2(std::cos(0.05 * k), std::sin(0.05 * k));
    wish.half_b = 30.0 * Vec2(-std::sin(0.05 * k), std::cos(0.05 * k));
    return wish;
  };
  std::vector<LabelMoment> moments;
  for (int k = 0; k < 60; ++k) {
    LabelMoment moment = moment_with({});
    moment.wishes[0] = wish_at(k);
    moment.shafts[0] = {kWish.at, kWish.at};
    moment.body = {Vec2(310, 0), Vec2(640, 0), Vec2(640, 360), Vec2(310, 360)};
    moments.push_back(moment);
  }
  const LabelTracks tracks(moments, kFrame, kGap);
  Vec2 before = tracks.place("name", wish_at(0.0), 0.0).center;
  for (double k = 0.0; k < 58.0; k += 0.5) {
    const LabelWish wish = wish_at(k);
    const LabelPlace place = tracks.place("name", wish, k);
    const TextRoom room = room_at(place.center, wish.width, wish.height);
    EXPECT_FALSE(overlap(room, moments.front().body)) << k;
    double nearest = HUGE_VAL;
    for (double angle = 0.0; angle < 2.0 * kPi; angle += 0.01) {
      const Vec2 on = wish.at + std::cos(angle) * wish.half_a + std::sin(angle) * wish.half_b;
      nearest = std::min(nearest, distance(room, on));
    }
    EXPECT_GT(nearest, 0.5 * kGap) << k;
    EXPECT_LT(nearest, 2.0 * kWish.height) << k;
    EXPECT_TRUE(place.opacity < 0.5 || (place.center - before).norm() < 8.0) << k;
    before = place.center;
  }
}

// where the frame holds a name, its ellipse goes away from under it: it stands still and is seen
TEST(LabelTracks, NamesAtTheEdgeOfTheFrameDoNotFlicker) {
  const auto wish_at = [](double k) {
    LabelWish wish = kWish;
    wish.at = {100.0, 180.0};
    wish.half_a = {75.0 + 20.0 * std::cos(k), 0.0};
    wish.half_b = {0.0, 300.0};  // nothing is free above and below
    return wish;
  };
  std::vector<LabelMoment> moments;
  for (int k = 0; k < 60; ++k) {
    LabelMoment moment = moment_with({});
    moment.wishes[0] = wish_at(k);
    moment.shafts[0] = {moment.wishes[0].at, moment.wishes[0].at};
    moment.body = {Vec2(90, 0), Vec2(640, 0), Vec2(640, 360), Vec2(90, 360)};
    moments.push_back(moment);
  }
  const LabelTracks tracks(moments, kFrame, kGap);
  for (double k = 0.0; k < 58.0; k += 0.5) {
    const LabelPlace place = tracks.place("name", wish_at(k), k);
    EXPECT_EQ(place.opacity, 1.0) << k;
    EXPECT_LT(place.center.x() + 0.5 * kWish.width, 90.0) << k << ": over the body";
  }
}

// a head that covers the end of a vector now and then does not draw its name to and fro
TEST(LabelTracks, NamesStayWithTheTipsWhoseEndsAreCovered) {
  std::vector<LabelMoment> moments;
  const auto wish_at = [](int k) {
    LabelWish wish = kWish;
    wish.to_tip = k % 4 < 2 ? Vec2(0.0, 0.0) : Vec2(0.0, -40.0);
    wish.at -= wish.to_tip;
    return wish;
  };
  for (int k = 0; k < 40; ++k) {
    LabelMoment moment = moment_with({});
    moment.wishes[0] = wish_at(k);
    moments.push_back(moment);
  }
  const LabelTracks tracks(moments, kFrame, kGap);
  const Vec2 first = tracks.place("name", wish_at(0), 0.0).center;
  for (int k = 0; k < 38; ++k) {
    const LabelPlace place = tracks.place("name", wish_at(k), k);
    EXPECT_LT((place.center - first).norm(), 0.6 * kWish.height) << k;
    EXPECT_EQ(place.opacity, 1.0) << k;
  }
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

// a tip that swings across a longer vector, by less than can be told, keeps its name where it is
TEST(LabelTracks, NamesStayOnTheirSidesOfVectorsThatCoincide) {
  std::vector<LabelMoment> moments;
  for (int k = 0; k < 80; ++k) {
    LabelMoment moment = moment_with({});
    moment.wishes[0].at.x() += 3.0 * std::sin(0.4 * k);
    moment.shafts[0].tip = moment.wishes[0].at;
    moment.names.push_back("other");
    moment.wishes.push_back({Vec2(300, 90), Vec2(0, -1), 20, 16});
    moment.shafts.push_back({Vec2(300, 300), Vec2(300, 90)});
    moments.push_back(moment);
  }
  const LabelTracks tracks(moments, kFrame, kGap);
  const auto is_left = [&](double at) {
    return tracks.place("name", kWish, at).center.x() < 300.0;
  };
  for (double at = 0.0; at < 79.0; at += 0.5)
    EXPECT_EQ(is_left(at), is_left(0.0)) << at;
}

// no head of another arrow between a name and its tip
TEST(LabelTracks, NamesAreNotBeyondTheHeadsOfOthers) {
  const TextRoom head{280, 150, 320, 178};
  const LabelMoment moment = moment_with({head});
  const LabelTracks tracks(std::vector<LabelMoment>(9, moment), kFrame, kGap);
  const Vec2 center = tracks.place("name", kWish, 4.0).center;
  EXPECT_FALSE(is_over(head, {center, kWish.at})) << center.transpose();
}

// the end of the longer of two parallel vectors is free, so that it leaves the side to the other
TEST(LabelTracks, ShortVectorsAreNamedFirst) {
  LabelMoment moment = moment_with({});
  moment.names = {"long", "name"};
  moment.wishes = {{Vec2(300, 140), Vec2(0, -1), 20, 16}, kWish};
  moment.shafts = {{Vec2(300, 300), Vec2(300, 140)}, {Vec2(304, 300), kWish.at}};
  // all but one side of the shorter is taken
  moment.obstacles.text = {{200, 100, 298, 360}};
  const LabelTracks tracks(std::vector<LabelMoment>(9, moment), kFrame, kGap);
  const Vec2 center = tracks.place("name", kWish, 4.0).center;
  EXPECT_LT((center - kWish.at).norm(), 30.0);
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
