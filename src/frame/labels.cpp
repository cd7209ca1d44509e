// SPDX-License-Identifier: MIT
#include "frame/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr int kRounds = 80;
constexpr int kRoundsWithShafts = 40;
// in heights of a capital: how far a name stands from its tip when its leader begins to show, and
// when it shows in full
constexpr double kLeaderBegins = 1.0, kLeaderIsWhole = 1.4;

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

TextRoom grown(const TextRoom& room, double across, double along) {
  return {room.left - across, room.top - along, room.right + across, room.bottom + along};
}

bool holds(const TextRoom& room, const Vec2& point) {
  constexpr double kRounding = 1e-9;
  return point.x() > room.left + kRounding && point.x() < room.right - kRounding &&
         point.y() > room.top + kRounding && point.y() < room.bottom - kRounding;
}

// The point nearest to `wished` in `bounds` that none of the rectangles holds; nothing if they hold
// all. It has the column of the wish or of an edge, and the row likewise.
std::optional<Vec2> nearest_free(const Vec2& wished,
                                 const std::vector<TextRoom>& blocked,
                                 const TextRoom& bounds) {
  std::vector<double> columns = {std::clamp(wished.x(), bounds.left, bounds.right)};
  std::vector<double> rows = {std::clamp(wished.y(), bounds.top, bounds.bottom)};
  for (const TextRoom& room : blocked) {
    for (const double x : {room.left, room.right})
      if (x >= bounds.left && x <= bounds.right) columns.push_back(x);
    for (const double y : {room.top, room.bottom})
      if (y >= bounds.top && y <= bounds.bottom) rows.push_back(y);
  }
  std::optional<Vec2> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double x : columns) {
    for (const double y : rows) {
      const Vec2 point(x, y);
      const double far = (point - wished).squaredNorm();
      if (far >= least) continue;
      const bool is_free = std::none_of(
          blocked.begin(), blocked.end(), [&](const TextRoom& room) { return holds(room, point); });
      if (!is_free) continue;
      best = point;
      least = far;
    }
  }
  return best;
}

// beside the point of the wish: as far along `away` that the room just leaves the point free
TextRoom wished_room(const LabelWish& wish, double gap) {
  const double reach =
      0.5 * (std::abs(wish.away.x()) * wish.width + std::abs(wish.away.y()) * wish.height);
  return room_at(wish.at + (reach + gap) * wish.away, wish.width, wish.height);
}

// a room that goes the shortest way to where it is clear of everything
TextRoom clear_of(const TextRoom& room,
                  const Obstacles& obstacles,
                  const std::vector<TextRoom>& labels,
                  const TextRoom& frame,
                  double gap) {
  const double half_width = 0.5 * room.width();
  const double half_height = 0.5 * room.height();
  TextRoom bounds = grown(frame, -half_width, -half_height);
  bounds.right = std::max(bounds.left, bounds.right);
  bounds.bottom = std::max(bounds.top, bounds.bottom);
  std::vector<TextRoom> blocked;
  const auto block = [&](const std::vector<TextRoom>& rooms, double space) {
    for (const TextRoom& other : rooms)
      blocked.push_back(grown(other, half_width + space, half_height + space));
  };
  block(obstacles.text, gap);
  block(labels, gap);
  const std::size_t without_marks = blocked.size();
  block(obstacles.marks, 0.5 * gap);
  std::optional<Vec2> free = nearest_free(room.center(), blocked, bounds);
  if (!free) {
    blocked.resize(without_marks);
    free = nearest_free(room.center(), blocked, bounds);
  }
  return room_at(free.value_or(room.center()), room.width(), room.height());
}

}  // namespace

bool overlap(const TextRoom& a, const TextRoom& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

// Labels push each other apart, half the way each; text does not give way, and shafts count only in
// the first rounds.
std::vector<Vec2> pushed_apart(const std::vector<LabelWish>& wishes,
                               const Obstacles& obstacles,
                               const std::vector<TextShaft>& shafts,
                               const TextRoom& frame,
                               double gap) {
  std::vector<TextRoom> rooms;
  for (const LabelWish& wish : wishes) {
    rooms.push_back(wished_room(wish, gap));
    keep_inside(rooms.back(), frame);
  }
  for (int round = 0; round < kRounds; ++round) {
    bool moved = false;
    const auto give_way = [&](TextRoom& room, const Vec2& way) {
      if (way == Vec2::Zero()) return;
      move(room, way);
      moved = true;
    };
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      for (const TextShaft& shaft : shafts) {
        if (round > kRoundsWithShafts) break;
        give_way(rooms[i], way_off(rooms[i], shaft, 0.5 * gap));
      }
      for (std::size_t k = i + 1; k < rooms.size(); ++k) {
        const Vec2 way = way_out(rooms[i], rooms[k], gap);
        give_way(rooms[i], 0.51 * way);
        give_way(rooms[k], -0.51 * way);
      }
      for (const TextRoom& mark : obstacles.marks)
        give_way(rooms[i], way_out(rooms[i], mark, 0.5 * gap));
      for (const TextRoom& text : obstacles.text)
        give_way(rooms[i], way_out(rooms[i], text, gap));
      keep_inside(rooms[i], frame);
    }
    if (!moved) break;
  }
  std::vector<Vec2> pushed;
  for (std::size_t i = 0; i < rooms.size(); ++i)
    pushed.emplace_back(rooms[i].center() - wished_room(wishes[i], gap).center());
  return pushed;
}

std::vector<TextRoom> settled(const std::vector<LabelWish>& wishes,
                              const std::vector<Vec2>& pushed,
                              const Obstacles& obstacles,
                              const TextRoom& frame,
                              double gap) {
  std::vector<TextRoom> rooms;
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    TextRoom room = wished_room(wishes[i], gap);
    move(room, pushed[i]);
    rooms.push_back(clear_of(room, obstacles, rooms, frame, gap));
  }
  return rooms;
}

double distance(const TextRoom& room, const Vec2& point) {
  const Vec2 inside(std::clamp(point.x(), room.left, room.right),
                    std::clamp(point.y(), room.top, room.bottom));
  return (point - inside).norm();
}

std::optional<Leader> leader_to(const Vec2& tip, const TextRoom& room, double letter) {
  const double away = distance(room, tip) / letter;
  if (away <= kLeaderBegins) return std::nullopt;
  // from the edge of the room, on the line through its middle
  const Vec2 way = tip - room.center();
  const double part =
      std::min(0.5 * room.width() / std::abs(way.x()), 0.5 * room.height() / std::abs(way.y()));
  const double opacity = std::min(1.0, (away - kLeaderBegins) / (kLeaderIsWhole - kLeaderBegins));
  return Leader{room.center() + part * way, tip, opacity};
}

}  // namespace polhode
