// SPDX-License-Identifier: MIT
#include "frame/labels.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr int kRounds = 200;
constexpr int kRoundsWithShafts = 40;
constexpr int kRoundsWithHeads = 120;

TextRoom room_at(const Vec2& center, double width, double height) {
  return {center.x() - 0.5 * width,
          center.y() - 0.5 * height,
          center.x() + 0.5 * width,
          center.y() + 0.5 * height};
}

void move(TextRoom& room, const Vec2& by) {
  room.left += by.x();
  room.right += by.x();
  room.top += by.y();
  room.bottom += by.y();
}

void keep_inside(TextRoom& room, const TextRoom& frame) {
  const auto shift = [](double low, double high, double least, double most) {
    if (low < least) return least - low;
    return high > most ? std::max(most - high, least - low) : 0.0;
  };
  move(room,
       {shift(room.left, room.right, frame.left, frame.right),
        shift(room.top, room.bottom, frame.top, frame.bottom)});
}

// the shortest way that brings `a` clear of `b` by the gap; zero when it is clear
Vec2 way_out(const TextRoom& a, const TextRoom& b, double gap) {
  const double right = b.right + gap - a.left;
  const double left = a.right + gap - b.left;
  const double down = b.bottom + gap - a.top;
  const double up = a.bottom + gap - b.top;
  if (right <= 0.0 || left <= 0.0 || down <= 0.0 || up <= 0.0) return Vec2::Zero();
  const double across = std::min(right, left);
  const double along = std::min(down, up);
  if (across < along) return {right < left ? right : -left, 0.0};
  return {0.0, down < up ? down : -up};
}

// the way sideways that brings a room off a shaft; zero when it is off
Vec2 way_off(const TextRoom& room, const TextShaft& shaft, double gap) {
  const Vec2 along = shaft.tip - shaft.from;
  const double length = along.norm();
  if (length < 1.0) return Vec2::Zero();
  const Vec2 e = along / length;
  const Vec2 n(-e.y(), e.x());
  const Vec2 from_tip = room.center() - shaft.from;
  const double half_along =
      0.5 * (std::abs(e.x()) * room.width() + std::abs(e.y()) * room.height());
  const double half_across =
      0.5 * (std::abs(n.x()) * room.width() + std::abs(n.y()) * room.height());
  const double s = e.dot(from_tip);
  if (s < -half_along || s > length + half_along) return Vec2::Zero();
  const double d = n.dot(from_tip);
  const double missing = half_across + gap - std::abs(d);
  if (missing <= 0.0) return Vec2::Zero();
  return (d < 0.0 ? -missing : missing) * n;
}

// The box around the head of an arrow; empty without a head.
TextRoom room_of_head(const TextShaft& shaft) {
  if (shaft.head_radius <= 0.0) return {};
  const Vec2 along = (shaft.tip - shaft.neck).stableNormalized();
  const Vec2 across = shaft.head_radius * Vec2(std::abs(along.y()), std::abs(along.x()));
  const Vec2 low = shaft.tip.cwiseMin(shaft.neck - across);
  const Vec2 high = shaft.tip.cwiseMax(shaft.neck + across);
  return {low.x(), low.y(), high.x(), high.y()};
}

}  // namespace

bool overlap(const TextRoom& a, const TextRoom& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

std::vector<TextRoom> place_labels(const std::vector<LabelWish>& wishes,
                                   const std::vector<TextRoom>& taken,
                                   const std::vector<TextShaft>& shafts,
                                   const TextRoom& frame,
                                   double gap) {
  std::vector<TextRoom> heads;
  for (const TextShaft& shaft : shafts) {
    // a name may stand closer to the head that it names
    const TextRoom head = room_of_head(shaft);
    const double inset = 0.5 * gap;
    if (std::min(head.width(), head.height()) <= 2.0 * inset) continue;
    heads.push_back({head.left + inset, head.top + inset, head.right - inset, head.bottom - inset});
  }
  std::vector<TextRoom> rooms;
  for (const LabelWish& wish : wishes) {
    // as far along `away` that the room just leaves the point free
    const double reach =
        0.5 * (std::abs(wish.away.x()) * wish.width + std::abs(wish.away.y()) * wish.height);
    rooms.push_back(room_at(wish.at + (reach + gap) * wish.away, wish.width, wish.height));
    keep_inside(rooms.back(), frame);
  }

  // labels push each other apart, half the way each; what is taken does not give way, and in the
  // last rounds it and the other labels are all that counts: shafts first, then heads are given up
  for (int round = 0; round < kRounds; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      for (const TextShaft& shaft : shafts) {
        if (round > kRoundsWithShafts) break;
        const Vec2 way = way_off(rooms[i], shaft, 0.5 * gap);
        if (way == Vec2::Zero()) continue;
        move(rooms[i], way);
        moved = true;
      }
      for (std::size_t k = i + 1; k < rooms.size(); ++k) {
        const Vec2 way = way_out(rooms[i], rooms[k], gap);
        if (way == Vec2::Zero()) continue;
        move(rooms[i], 0.51 * way);
        move(rooms[k], -0.51 * way);
        moved = true;
      }
      for (const TextRoom& head : heads) {
        if (round > kRoundsWithHeads) break;
        const Vec2 way = way_out(rooms[i], head, gap);
        if (way == Vec2::Zero()) continue;
        move(rooms[i], way);
        moved = true;
      }
      for (const TextRoom& obstacle : taken) {
        const Vec2 way = way_out(rooms[i], obstacle, gap);
        if (way == Vec2::Zero()) continue;
        move(rooms[i], way);
        moved = true;
      }
      keep_inside(rooms[i], frame);
    }
    if (!moved) break;
  }
  return rooms;
}

}  // namespace polhode
