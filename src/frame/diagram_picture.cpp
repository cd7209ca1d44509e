// SPDX-License-Identifier: MIT
#include "frame/diagram_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "frame/lettering.h"

namespace polhode {
namespace {

using Kind = DiagramCurve::Kind;

// of what there is, at most
constexpr double kMostOfHeight = 0.075, kMostOfWidth = 0.045;
constexpr double kHighest = 0.9;  // of its width
constexpr double kFaint = 0.55;   // width of curves of other motions, of that of this one
constexpr double kMark = 0.7;     // radius of a mark, of that of the dot

// where the middle of a name may be, from its mark, in their sizes; the first is the most usual
const std::array<Vec2, 8> kSidesOfMarks = {{{1.0, -1.0},
                                            {-1.0, -1.0},
                                            {1.0, 1.0},
                                            {-1.0, 1.0},
                                            {0.0, -1.0},
                                            {0.0, 1.0},
                                            {1.0, 0.0},
                                            {-1.0, 0.0}}};
constexpr double kReadsOn = 5.0;  // the price of two names that are read as one
constexpr double kStrays = 3.0;   // that of a name which is not clearly nearest to its own mark
constexpr double kPassed = 1.0;   // that of a name that the dot covers for a moment
constexpr double kClearly = 1.4;  // so many times as far all others are

// how curves of a kind, and their names, are drawn
struct CurveStyle {
  glm::vec3 color;
  double width = 1.0;  // of that of curves
  const char* name = nullptr;
  double importance = 1.0;  // how bad it is that a name hides a piece
};

CurveStyle style_of(Kind kind, const Theme& theme) {
  switch (kind) {
    case Kind::motion:
      return {theme.omega, 1.0, nullptr, 3.0};
    case Kind::potential:
      return {theme.momentum, 1.0, "U", 4.0};
    case Kind::energy:
      return {theme.omega, kFaint, "E", 1.0};
    case Kind::separatrix:
      return {theme.velocity, 1.0, "separatrix", 3.0};
    case Kind::boundary:
      return {theme.momentum, 1.0, "stable within", 2.0};
    case Kind::other:
      return {theme.space_axes, kFaint};
  }
  return {theme.position};
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{}, {}", name, unit);
}

}  // namespace

// Long, because each length follows from those before it.
DiagramPicture::DiagramPicture(Diagram diagram,
                               const PixelBox& room,
                               double size,
                               const Theme& theme,
                               const Typesetter& typesetter,
                               int left)
    : diagram_(std::move(diagram)),
      paper_(theme,
             typesetter,
             std::min({size, kMostOfHeight * room.height, kMostOfWidth * room.width})) {
  const double type = paper_.size();
  const auto rounded = [](double value) {
    return static_cast<int>(std::lround(value));
  };
  const double pad = kPlotPad * type;
  const double width = room.width - 2.0 * pad;
  const double height = std::min(room.height - 2.0 * pad, kHighest * width);
  const double top = room.y + 0.5 * (room.height - height);
  axes_.y = rounded(top + (kPlotHeading + kPlotOver) * type);
  axes_.height = std::max(1, rounded(top + height - kPlotColumns * type) - axes_.y);

  const auto ink_height = [&](const std::string& text) {
    return paper_.ink_height(text);
  };
  const auto ink_width = [&](const std::string& text) {
    return paper_.ink_width(text);
  };
  const DiagramAxis &across = diagram_.across, &up = diagram_.up;
  const Ticks rows = choose_ticks(up.low, up.high, axes_.height, ink_height, kPlotAbove * type);
  double widest = 0.0;
  for (const std::string& label : rows.labels)
    widest = std::max(widest, ink_width(label));
  axes_.x = std::max(left, rounded(room.x + pad + widest + (kPlotTick + kPlotTickGap) * type));
  // the last label below stands half beside the axes
  axes_.width = std::max(1, rounded(room.right() - pad - 1.5 * type) - axes_.x);
  const Ticks columns =
      choose_ticks(across.low, across.high, axes_.width, ink_width, kPlotAside * type);

  std::vector<PlotEntry> entries;
  for (const Kind kind : {Kind::potential, Kind::energy, Kind::separatrix, Kind::boundary}) {
    const bool is_there = std::any_of(diagram_.curves.begin(),
                                      diagram_.curves.end(),
                                      [&](const DiagramCurve& one) { return one.kind == kind; });
    const CurveStyle style = style_of(kind, theme);
    if (is_there) entries.push_back({style.name, style.color});
  }
  const std::string what =
      up.name.empty() ? diagram_.title : fmt::format("{}: {}", diagram_.title, up.name);
  paper_.add_heading(
      with_unit(what, scaled_unit(rows.exponent, up.unit)),
      entries,
      {rounded(room.x + pad), rounded(top), rounded(width), rounded(kPlotHeading * type)});
  paper_.add_rows(axes_, rows, [&](double value) { return pixel({across.low, value}).y; });
  paper_.add_columns(
      axes_,
      columns,
      [&](double value) {
        return pixel({value, up.low}).x;
      },
      with_unit(across.name, scaled_unit(columns.exponent, across.unit)));
  paper_.add_axes(axes_);
  add_curves();
  add_marks(typesetter);
}

LinePoint DiagramPicture::pixel(const Vec2& point) const {
  const auto part = [](const DiagramAxis& axis, double value) {
    return std::clamp((value - axis.low) / (axis.high - axis.low), 0.0, 1.0);
  };
  return {axes_.x + part(diagram_.across, point.x()) * axes_.width,
          axes_.bottom() - part(diagram_.up, point.y()) * axes_.height};
}

// those of other motions first
void DiagramPicture::add_curves() {
  const int rim = static_cast<int>(std::ceil(paper_.line()));
  Sprite sprite(axes_.width + 2 * rim, axes_.height + 2 * rim);
  for (const Kind kind : {Kind::other,
                          Kind::boundary,
                          Kind::separatrix,
                          Kind::potential,
                          Kind::energy,
                          Kind::motion}) {
    std::vector<Polyline> lines;
    for (const DiagramCurve& curve : diagram_.curves) {
      if (curve.kind != kind) continue;
      Polyline line;
      for (const Vec2& point : curve.points) {
        const LinePoint at = pixel(point);
        line.push_back({at.x - axes_.x + rim, at.y - axes_.y + rim});
      }
      lines.push_back(std::move(line));
    }
    const CurveStyle style = style_of(kind, paper_.theme());
    stroke(sprite, lines, std::max(1.0, style.width * paper_.line()), bytes_of(style.color));
  }
  curves_.push_back(
      {std::make_shared<const Sprite>(std::move(sprite)), axes_.x - rim, axes_.y - rim});
}

double DiagramPicture::hidden_by(const TextRoom& room) const {
  const auto place = [&](const Vec2& point) {
    const LinePoint at = pixel(point);
    return Vec2(at.x, at.y);
  };
  // the dot of the motion goes along these, and hides what it passes
  const double of_dot = kPlotDot * paper_.size() + paper_.line();
  const TextRoom with_dot = grown(room, of_dot, of_dot);
  double hidden = 0.0;
  for (const DiagramCurve& curve : diagram_.curves) {
    double price = 0.0;
    const bool has_dot = curve.kind == Kind::motion || curve.kind == Kind::potential;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const Vec2 from = place(curve.points[i - 1]), to = place(curve.points[i]);
      // in small pictures pieces are shorter than a pixel, of which is_over() says nothing
      const auto meets = [&](const TextRoom& area) {
        return distance(area, to) <= 0.0 || is_over(area, {from, to});
      };
      if (meets(room)) {
        price = style_of(curve.kind, paper_.theme()).importance;
        break;
      }
      if (has_dot && meets(with_dot)) price = kPassed;
    }
    hidden += price;
  }
  return hidden;
}

// discs, of what is unstable with a hole; names beside them, off other names
void DiagramPicture::add_marks(const Typesetter& typesetter) {
  const double radius = kMark * kPlotDot * paper_.size();
  Obstacles obstacles;
  for (const DiagramMark& mark : diagram_.marks) {
    const LinePoint at = pixel(mark.at);
    obstacles.marks.push_back(room_at({at.x, at.y}, 2.0 * radius, 2.0 * radius));
  }
  std::vector<TextRoom> names;
  const TextRoom frame{1.0 * axes_.x, 1.0 * axes_.y, 1.0 * axes_.right(), 1.0 * axes_.bottom()};
  const TextStyle style = paper_.style(paper_.theme().position);
  for (const DiagramMark& mark : diagram_.marks) {
    const LinePoint at = pixel(mark.at);
    const int left = static_cast<int>(std::floor(at.x - radius)) - 2;
    const int top = static_cast<int>(std::floor(at.y - radius)) - 2;
    const int side = static_cast<int>(std::ceil(2.0 * radius)) + 5;
    Sprite disc(side, side);
    const std::vector<Polyline> place{{{at.x - left, at.y - top}}};
    stroke(disc, place, 2.0 * radius, bytes_of(paper_.theme().position));
    if (!mark.stable) stroke(disc, place, 1.1 * radius, bytes_of(paper_.theme().background));
    curves_.push_back({std::make_shared<const Sprite>(std::move(disc)), left, top});
    if (mark.name.empty()) continue;
    const TextBox box = typesetter.measure(plain_text(mark.name), style);
    // above it to the right if nothing is hidden there, no name is so near that both would be read
    // as one, and no other mark is as near; else where this is less
    const LabelWish wish{{at.x, at.y}, {1.0, -1.0}, box.ink_width(), box.ink_height()};
    const double gap = radius + 0.3 * paper_.size();
    Vec2 best = Vec2::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (const double far : {1.0, 2.0}) {
      for (const Vec2& toward : kSidesOfMarks) {
        const Vec2 reach(far * 1.5 * radius + 0.5 * wish.width, far * gap + 0.5 * wish.height);
        const Vec2 center = settled_at(wish,
                                       wish.at + toward.cwiseProduct(reach),
                                       obstacles,
                                       names,
                                       frame,
                                       0.2 * paper_.size());
        const auto around = [&](double letters) {
          return grown(room_at(center, wish.width, wish.height), letters * paper_.size(), 0.0);
        };
        const bool reads_on = std::any_of(names.begin(), names.end(), [&](const TextRoom& name) {
          return overlap(name, around(0.5));
        });
        const double away = (center - wish.at).norm();
        const bool strays = std::any_of(
            diagram_.marks.begin(), diagram_.marks.end(), [&](const DiagramMark& other) {
              const LinePoint there = pixel(other.at);
              return &other != &mark && (center - Vec2(there.x, there.y)).norm() < kClearly * away;
            });
        const double price = hidden_by(around(0.15)) + (reads_on ? kReadsOn : 0.0) +
                             (strays ? kStrays : 0.0) + away / (10.0 * paper_.size());
        if (price >= least) continue;
        least = price;
        best = center;
      }
    }
    names.push_back(room_at(best, box.ink_width(), box.ink_height()));
    paper_.add_text(
        mark.name, style, names.back().left - box.ink_left, names.back().top - box.ink_top);
  }
}

void DiagramPicture::draw(double t, std::vector<Stamp>& stamps) const {
  // names have rims: curves go under them
  stamps.insert(stamps.end(), curves_.begin(), curves_.end());
  stamps.insert(stamps.end(), paper_.stamps().begin(), paper_.stamps().end());
  stamps.push_back(paper_.dot(pixel(diagram_.now(t)), paper_.theme().omega));
}

}  // namespace polhode
