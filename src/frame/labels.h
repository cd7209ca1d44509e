// SPDX-License-Identifier: MIT
// Places labels so that they do not overlap each other or other text.
#pragma once

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

// A drawn vector that labels should not cover; pixels, y down. Its head, a triangle from the tip to
// the neck, may be covered even less.
struct TextShaft {
  Vec2 from, tip;
  Vec2 neck = Vec2::Zero();
  double head_radius = 0.0;  // at the neck; 0: there is no head
};

// Whether the rectangles have a common area.
bool overlap(const TextRoom& a, const TextRoom& b);

// A label that should stand beside `at`, in the direction of the unit vector `away`; pixels, y
// down.
struct LabelWish {
  Vec2 at;
  Vec2 away;
  double width = 0.0;   // of its ink (TextBox in text/typesetter.h)
  double height = 0.0;  // of its ink
};

// The rectangle of each wish, in the order of the wishes, inside `frame`. Rectangles keep at least
// `gap` pixels from `taken` and from each other if there is enough space, and keep off the heads of
// `shafts`, and off their shafts where possible. A pure function: a picture does not depend on
// which one was drawn before it.
std::vector<TextRoom> place_labels(const std::vector<LabelWish>& wishes,
                                   const std::vector<TextRoom>& taken,
                                   const std::vector<TextShaft>& shafts,
                                   const TextRoom& frame,
                                   double gap);

}  // namespace polhode
