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

constexpr double kRounding = 1e-9;  // px

bool holds_column(const TextRoom& room, double x) {
  return x > room.left + kRounding && x < room.right - kRounding;
}

}  // namespace

FreeSpace::FreeSpace(const std::vector<TextRoom>& blocked, const TextRoom& bounds)
    : blocked_(blocked), bounds_(bounds) {
  std::sort(blocked_.begin(), blocked_.end(), [](const TextRoom& a, const TextRoom& b) {
    return a.top < b.top;
  });
  for (const TextRoom& room : blocked_) {
    for (const double x : {room.left, room.right})
      if (x >= bounds.left && x <= bounds.right) columns_.push_back({x});
  }
  std::sort(
      columns_.begin(), columns_.end(), [](const Column& a, const Column& b) { return a.x < b.x; });
}

// Rows of rectangles that overlap are joined, so that those of a column are apart.
void FreeSpace::find_rows_of(Column& column) const {
  column.is_known = true;
  std::vector<Rows>& taken = column.taken;
  for (const TextRoom& room : blocked_) {
    if (!holds_column(room, column.x)) continue;
    if (!taken.empty() && room.top < taken.back().bottom - kRounding) {
      taken.back().bottom = std::max(taken.back().bottom, room.bottom);
    } else {
      taken.push_back({room.top, room.bottom});
    }
  }
}

std::optional<double> FreeSpace::nearest_row(Column& column, double wished) const {
  if (!column.is_known) find_rows_of(column);
  const double y = std::clamp(wished, bounds_.top, bounds_.bottom);
  const auto after = std::upper_bound(
      column.taken.begin(), column.taken.end(), y, [](double row, const Rows& rows) {
        return row < rows.top;
      });
  if (after == column.taken.begin()) return y;
  const Rows& rows = *(after - 1);
  if (y < rows.top + kRounding || y > rows.bottom - kRounding) return y;
  const bool may_above = rows.top >= bounds_.top, may_below = rows.bottom <= bounds_.bottom;
  if (!may_above && !may_below) return std::nullopt;
  if (!may_below || (may_above && wished - rows.top <= rows.bottom - wished)) return rows.top;
  return rows.bottom;
}

std::optional<Vec2> FreeSpace::nearest(const Vec2& wished) {
  std::optional<Vec2> best;
  double least = std::numeric_limits<double>::infinity();
  const auto look_at = [&](Column& column) {
    const std::optional<double> y = nearest_row(column, wished.y());
    if (!y) return;
    const double far = (Vec2(column.x, *y) - wished).norm();
    if (far >= least) return;
    best = Vec2(column.x, *y);
    least = far;
  };
  Column own{std::clamp(wished.x(), bounds_.left, bounds_.right)};
  look_at(own);
  // outwards from the wish, until all others are farther
  auto right = std::lower_bound(
      columns_.begin(), columns_.end(), wished.x(), [](const Column& column, double x) {
        return column.x < x;
      });
  for (auto left = right; left != columns_.begin();) {
    --left;
    if (wished.x() - left->x >= least) break;
    look_at(*left);
  }
  for (; right != columns_.end() && right->x - wished.x() < least; ++right)
    look_at(*right);
  return best;
}

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

double gap_between_names(const LabelWish& wish, double gap) {
  constexpr double kApart = 0.7;  // heights of the label
  return std::max(gap, kApart * wish.height);
}

LabelRoom::LabelRoom(const LabelWish& wish,
                     const Obstacles& obstacles,
                     const std::vector<TextRoom>& labels,
                     const TextRoom& frame,
                     double gap) {
  const double half_width = 0.5 * wish.width;
  const double half_height = 0.5 * wish.height;
  bounds_ = grown(frame, -half_width, -half_height);
  bounds_.right = std::max(bounds_.left, bounds_.right);
  bounds_.bottom = std::max(bounds_.top, bounds_.bottom);
  std::vector<TextRoom> blocked;
  const auto block = [&](const std::vector<TextRoom>& rooms, double across, double along) {
    for (const TextRoom& other : rooms)
      blocked.push_back(grown(other, half_width + across, half_height + along));
  };
  block(obstacles.text, gap, gap);
  block(labels, gap_between_names(wish, gap), gap);
  beside_text_ = blocked;
  block(obstacles.marks, 0.5 * gap, 0.5 * gap);
  free_ = FreeSpace(blocked, bounds_);
}

Vec2 LabelRoom::settled_at(const Vec2& center) {
  if (const std::optional<Vec2> place = free_.nearest(center)) return *place;
  if (!over_marks_) over_marks_.emplace(beside_text_, bounds_);
  return over_marks_->nearest(center).value_or(center);
}

Vec2 settled_at(const LabelWish& wish,
                const Vec2& center,
                const Obstacles& obstacles,
                const std::vector<TextRoom>& labels,
                const TextRoom& frame,
                double gap) {
  return LabelRoom(wish, obstacles, labels, frame, gap).settled_at(center);
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
