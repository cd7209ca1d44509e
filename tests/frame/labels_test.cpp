// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "frame/label_tracks.h"

namespace polhode {
namespace {

std::vector<TextRoom> placed(const std::vector<LabelWish>& wishes,
                             const Obstacles& obstacles,
                             const std::vector<TextShaft>& shafts,
                             const TextRoom& frame,
                             double gap) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < wishes.size(); ++i)
    names.push_back(std::to_string(i));
  const LabelTracks tracks({{names, wishes, shafts, obstacles}}, frame, gap);
  std::vector<TextRoom> rooms;
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    const LabelPlace place = tracks.place(names[i], wishes[i], 0.0);
    EXPECT_EQ(place.opacity, 1.0);
    rooms.push_back(room_at(place.center, wishes[i].width, wishes[i].height));
  }
  return rooms;
}

class LabelsAnywhere : public ::testing::TestWithParam<unsigned> {};

// labels that start anywhere, even in one heap, end apart and inside
TEST_P(LabelsAnywhere, StandApartAndInside) {
  std::mt19937_64 random(GetParam());
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const TextRoom frame{10, 10, 630, 350};
  const std::vector<TextRoom> taken = {{10, 10, 300, 40}, {500, 320, 630, 350}};
  std::vector<LabelWish> wishes;
  std::vector<TextShaft> shafts;
  std::vector<TextRoom> marks;
  for (int i = 0; i < 9; ++i) {
    const double heap = GetParam() % 2 == 0 ? 0.1 : 1.0;
    const Vec2 at(320 + 300 * heap * (uniform(random) - 0.5),
                  180 + 160 * heap * (uniform(random) - 0.5));
    const double angle = 6.28 * uniform(random);
    wishes.push_back({at, {std::cos(angle), std::sin(angle)}, 12 + 20 * uniform(random), 18.0});
    shafts.push_back({Vec2(320, 180), at});
    marks.push_back({at.x() - 5.0, at.y() - 5.0, at.x() + 5.0, at.y() + 5.0});
  }
  const std::vector<TextRoom> rooms = placed(wishes, {taken, marks}, shafts, frame, 4.0);
  ASSERT_EQ(rooms.size(), wishes.size());
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    EXPECT_GE(rooms[i].left, frame.left - 1e-9);
    EXPECT_LE(rooms[i].right, frame.right + 1e-9);
    EXPECT_GE(rooms[i].top, frame.top - 1e-9);
    EXPECT_LE(rooms[i].bottom, frame.bottom + 1e-9);
    EXPECT_NEAR(rooms[i].width(), wishes[i].width, 1e-9);
    for (std::size_t k = i + 1; k < rooms.size(); ++k)
      EXPECT_FALSE(overlap(rooms[i], rooms[k]));
    for (const TextRoom& obstacle : taken)
      EXPECT_FALSE(overlap(rooms[i], obstacle));
    for (const TextRoom& mark : marks)
      EXPECT_FALSE(overlap(rooms[i], mark));
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, LabelsAnywhere, ::testing::Range(0u, 40u));

TEST(Labels, ALonelyOneStandsBeyondTheTip) {
  const TextRoom frame{0, 0, 640, 360};
  const std::vector<TextRoom> rooms = placed(
      {{Vec2(300, 200), Vec2(1, 0), 20, 16}}, {}, {{Vec2(200, 200), Vec2(300, 200)}}, frame, 4.0);
  EXPECT_NEAR(rooms[0].left, 304.0, 1e-9);
  EXPECT_NEAR(rooms[0].center().y(), 200.0, 1e-9);
}

// a label keeps its distance from a vector that it would stand on
TEST(Labels, StandBesideShafts) {
  const TextRoom frame{0, 0, 640, 360};
  const std::vector<TextShaft> shafts = {{Vec2(100, 100), Vec2(500, 100)}};
  const std::vector<TextRoom> rooms =
      placed({{Vec2(300, 90), Vec2(0, 1), 20, 16}}, {}, shafts, frame, 4.0);
  EXPECT_TRUE(rooms[0].bottom < 100.0 || rooms[0].top > 100.0)
      << rooms[0].top << ' ' << rooms[0].bottom;
}

// two vectors in one line: the name of the shorter one stands beside the head of the longer one
TEST(Labels, KeepOffHeads) {
  const TextRoom frame{0, 0, 640, 360};
  const std::vector<TextShaft> shafts = {{Vec2(300, 300), Vec2(300, 100)},
                                         {Vec2(300, 300), Vec2(300, 150)}};
  const std::vector<TextRoom> heads = {{282, 100, 318, 150}, {278, 150, 322, 190}};
  const std::vector<LabelWish> wishes = {{Vec2(300, 100), Vec2(0, -1), 20, 16},
                                         {Vec2(300, 150), Vec2(0, -1), 20, 16}};
  const std::vector<TextRoom> rooms = placed(wishes, {{}, heads}, shafts, frame, 4.0);
  for (const TextRoom& room : rooms) {
    for (const TextRoom& head : heads)
      EXPECT_FALSE(overlap(room, head));
  }
  EXPECT_LT(rooms[0].bottom, 100.0);
  // still near its own tip
  EXPECT_LT((rooms[1].center() - Vec2(300, 150)).norm(), 60.0);
}

// against all columns and rows of edges, each tried in all rectangles
TEST(FreeSpace, FindsTheNearestPoint) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const TextRoom bounds{0, 0, 400, 200};
  const auto anywhere = [&] {
    return Vec2(440.0 * uniform(random) - 20.0, 220.0 * uniform(random) - 10.0);
  };
  int without = 0;
  for (int run = 0; run < 60; ++run) {
    std::vector<TextRoom> rooms;
    for (int i = 0; i < 5 * (run % 12); ++i)
      rooms.push_back(room_at(anywhere(), 90.0 * uniform(random), 40.0 * uniform(random)));
    if (run % 20 == 19) rooms.push_back({-1, -1, 401, 201});
    FreeSpace space(rooms, bounds);
    for (int look = 0; look < 20; ++look) {
      const Vec2 wished = anywhere();
      std::vector<double> columns = {std::clamp(wished.x(), bounds.left, bounds.right)};
      std::vector<double> rows = {std::clamp(wished.y(), bounds.top, bounds.bottom)};
      for (const TextRoom& room : rooms) {
        columns.insert(columns.end(), {room.left, room.right});
        rows.insert(rows.end(), {room.top, room.bottom});
      }
      double least = HUGE_VAL;
      for (const double x : columns) {
        for (const double y : rows) {
          const auto holds = [&](const TextRoom& room) {
            return x > room.left && x < room.right && y > room.top && y < room.bottom;
          };
          const bool inside =
              x >= bounds.left && x <= bounds.right && y >= bounds.top && y <= bounds.bottom;
          if (inside && std::none_of(rooms.begin(), rooms.end(), holds))
            least = std::min(least, (Vec2(x, y) - wished).norm());
        }
      }
      const std::optional<Vec2> found = space.nearest(wished);
      ASSERT_EQ(found.has_value(), std::isfinite(least));
      if (found) {
        EXPECT_NEAR((*found - wished).norm(), least, 1e-6);
      }
      without += found ? 0 : 1;
    }
  }
  EXPECT_GT(without, 0);
}

TEST(Labels, RoomsOverlapPolygons) {
  const std::vector<Vec2> triangle = {{0, 0}, {100, 0}, {0, 100}};
  EXPECT_TRUE(overlap({10, 10, 20, 20}, triangle)) << "inside";
  EXPECT_TRUE(overlap({-10, -10, 200, 200}, triangle)) << "around it";
  EXPECT_TRUE(overlap({45, 45, 80, 80}, triangle)) << "a corner is over the long side";
  EXPECT_FALSE(overlap({55, 55, 80, 80}, triangle)) << "in its box, but beyond the long side";
  EXPECT_FALSE(overlap({-30, 10, -1, 20}, triangle));
  EXPECT_FALSE(overlap({10, 10, 20, 20}, std::vector<Vec2>{}));
}

TEST(Labels, RoomsThatTouchDoNotOverlap) {
  const TextRoom room{0, 0, 10, 10};
  EXPECT_FALSE(overlap(room, {10, 0, 20, 10}));
  EXPECT_FALSE(overlap(room, {0, 10, 10, 20}));
  EXPECT_TRUE(overlap(room, {9, 9, 20, 20}));
  EXPECT_TRUE(overlap(room, {2, 2, 3, 3}));
}

}  // namespace
}  // namespace polhode
