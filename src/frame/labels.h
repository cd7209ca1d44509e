// SPDX-License-Identifier: MIT
// Places labels so that they overlap neither each other nor other text nor heads of arrows.
#pragma once

#include <optional>
#include <vector>

#include "math/notation.h"

namespace polhode {

// A rectangle in pixels, y down.
struct TextRoom {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  Vec2 center() const { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
};

// A drawn vector that labels should not cover; pixels, y down.
struct TextShaft {
  Vec2 from, tip;
};

// What labels must keep off, pixels, y down. Those that cannot be clear of all of it give up
// `marks` first.
struct Obstacles {
  std::vector<TextRoom> text;   // other text
  std::vector<TextRoom> marks;  // heads of arrows, points of contact
};

// A thin line from a label to the tip that it names; pixels, y down.
struct Leader {
  Vec2 from, to;
  double opacity = 1.0;  // 0..1
};

// A rectangle by its middle and size.
TextRoom room_at(const Vec2& center, double width, double height);
// The rectangle with that much more on the left and right, and above and below.
TextRoom grown(const TextRoom& room, double across, double along);
// Whether a rectangle covers a part of a shaft.
bool is_over(const TextRoom& room, const TextShaft& shaft);
// Whether a rectangle and a convex polygon have a common area. Corners in turn, either way round.
bool overlap(const TextRoom& room, const std::vector<Vec2>& polygon);
// Whether the rectangles have a common area.
bool overlap(const TextRoom& a, const TextRoom& b);

// A label that should stand beside `at`, in the direction of the unit vector `away`; pixels, y
// down.
struct LabelWish {
  Vec2 at;
  Vec2 away;
  double width = 0.0;   // of its ink (TextBox in text/typesetter.h)
  double height = 0.0;  // of its ink
  // From `at` to the point with which it moves: the tip of a vector of which the end is covered.
  Vec2 to_tip = Vec2::Zero();
  // Half axes of the ellipse about `at` around which it may stand anywhere; zero: it stands at
  // `at`.
  Vec2 half_a = Vec2::Zero(), half_b = Vec2::Zero();

  Vec2 tip() const { return at + to_tip; }
  bool is_around() const { return !half_a.isZero() || !half_b.isZero(); }
};

// How far a label keeps from others beside it (px), so that two are not read as one word, where
// `gap` is what it keeps from all else.
double gap_between_names(const LabelWish& wish, double gap);

// The points between rectangles, pixels, y down. What has been found about them is kept, so that
// many points can be looked up.
class FreeSpace {
 public:
  FreeSpace() = default;
  FreeSpace(const std::vector<TextRoom>& blocked, const TextRoom& bounds);

  // The point nearest to `wished` in the bounds that no rectangle holds; nothing if they hold all.
  // It is in the column of the wish or of an edge.
  std::optional<Vec2> nearest(const Vec2& wished);

 private:
  struct Rows {
    double top, bottom;
  };
  struct Column {
    double x;
    bool is_known = false;
    std::vector<Rows> taken = {};  // rows that rectangles hold in it, apart and in order
  };
  void find_rows_of(Column& column) const;
  std::optional<double> nearest_row(Column& column, double wished) const;

  std::vector<TextRoom> blocked_;  // from top to bottom
  TextRoom bounds_;
  std::vector<Column> columns_;  // of the edges, from left to right
};

// Where one label may stand inside `frame`.
class LabelRoom {
 public:
  LabelRoom(const LabelWish& wish,
            const Obstacles& obstacles,
            const std::vector<TextRoom>& labels,
            const TextRoom& frame,
            double gap);

  // The middle of the label that should stand around `center`. It overlaps neither other labels nor
  // obstacles if there is enough space: where it would, it goes the shortest way that keeps `gap`
  // pixels from text and labels above and below, gap_between_names() from labels beside it, and
  // half of `gap` from marks.
  Vec2 settled_at(const Vec2& center);

 private:
  std::vector<TextRoom> beside_text_;  // where its middle is too near to text and labels
  TextRoom bounds_;
  FreeSpace free_;
  std::optional<FreeSpace> over_marks_;  // what is free without them; absent: not needed yet
};

// The same for a single place.
Vec2 settled_at(const LabelWish& wish,
                const Vec2& center,
                const Obstacles& obstacles,
                const std::vector<TextRoom>& labels,
                const TextRoom& frame,
                double gap);

// How far a point is from a rectangle, pixels; 0 inside.
double distance(const TextRoom& room, const Vec2& point);

// The line from a label to the tip of its arrow, or to where that leaves the picture. It fades in
// while the label is between 1 and 1.4 times `letter` from the tip, the height of a capital
// (pixels); nearer there is none.
std::optional<Leader> leader_to(const Vec2& tip, const TextRoom& room, double letter);

}  // namespace polhode
