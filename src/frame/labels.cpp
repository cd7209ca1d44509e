// SPDX-License-Identifier: MIT
#include "frame/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

// in heights of a capital: how far a name stands from its tip when its leader begins to show, and
// when it shows in full
constexpr double kLeaderBegins = 1.0, kLeaderIsWhole = 1.4;

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

}  // namespace

TextRoom room_at(const Vec2& center, double width, double height) {
  return {center.x() - 0.5 * width,
          center.y() - 0.5 * height,
          center.x() + 0.5 * width,
          center.y() + 0.5 * height};
}

TextRoom grown(const TextRoom& room, double across, double along) {
  return {room.left - across, room.top - along, room.right + across, room.bottom + along};
}

bool is_over(const TextRoom& room, const TextShaft& shaft) {
  // most are far away
  if (std::max(shaft.from.x(), shaft.tip.x()) < room.left ||
      std::min(shaft.from.x(), shaft.tip.x()) > room.right ||
      std::max(shaft.from.y(), shaft.tip.y()) < room.top ||
      std::min(shaft.from.y(), shaft.tip.y()) > room.bottom)
    return false;
  const Vec2 along = shaft.tip - shaft.from;
  const double length = along.norm();
  if (length < 1.0) return false;
  const Vec2 e = along / length;
  const Vec2 n(-e.y(), e.x());
  const Vec2 from_foot = room.center() - shaft.from;
  const double half_along =
      0.5 * (std::abs(e.x()) * room.width() + std::abs(e.y()) * room.height());
  const double half_across =
      0.5 * (std::abs(n.x()) * room.width() + std::abs(n.y()) * room.height());
  const double s = e.dot(from_foot);
  if (s < -half_along || s > length + half_along) return false;
  return std::abs(n.dot(from_foot)) < half_across;
}

bool overlap(const TextRoom& room, const std::vector<Vec2>& polygon) {
  const std::size_t count = polygon.size();
  if (count < 3) return false;
  const Vec2 corners[] = {{room.left, room.top},
                          {room.right, room.top},
                          {room.left, room.bottom},
                          {room.right, room.bottom}};
  // do all points lie on one side of a line, and all of the others on the other?
  const auto parts = [&](const Vec2& normal) {
    double low = HUGE_VAL, high = -HUGE_VAL, lowest = HUGE_VAL, highest = -HUGE_VAL;
    for (const Vec2& corner : corners) {
      low = std::min(low, normal.dot(corner));
      high = std::max(high, normal.dot(corner));
    }
    for (const Vec2& corner : polygon) {
      lowest = std::min(lowest, normal.dot(corner));
      highest = std::max(highest, normal.dot(corner));
    }
    return high <= lowest || highest <= low;
  };
  if (parts(Vec2::UnitX()) || parts(Vec2::UnitY())) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 side = polygon[(i + 1) % count] - polygon[i];
    if (parts(Vec2(-side.y(), side.x()))) return false;
  }
  return true;
}

bool overlap(const TextRoom& a, const TextRoom& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

Vec2 settled_at(const LabelWish& wish,
                const Vec2& center,
                const Obstacles& obstacles,
                const std::vector<TextRoom>& labels,
                const TextRoom& frame,
                double gap) {
  const double half_width = 0.5 * wish.width;
  const double half_height = 0.5 * wish.height;
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
  std::optional<Vec2> free = nearest_free(center, blocked, bounds);
  if (!free) {
    blocked.resize(without_marks);
    free = nearest_free(center, blocked, bounds);
  }
  return free.value_or(center);
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
