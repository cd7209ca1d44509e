// SPDX-License-Identifier: MIT
// Where labels go so that they can be read.
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

// A drawn vector that labels should not hide.
struct TextShaft {
  Vec2 from, tip;
};

bool overlap(const TextRoom& a, const TextRoom& b);

// A label that wants to stand beside `at`, on the side that `away` (unit) points to.
struct LabelWish {
  Vec2 at;
  Vec2 away;
  double width = 0.0;  // of its ink
  double height = 0.0;
};

// One room for each wish, inside `frame`, free of `taken` and of each other by at least `gap`
// pixels where there is space enough, and off the shafts of vectors where that costs no more. A
// function of its arguments alone, so that a film looks the same from whichever frame it is drawn;
// labels that move slowly are moved slowly.
std::vector<TextRoom> place_labels(const std::vector<LabelWish>& wishes,
                                   const std::vector<TextRoom>& taken,
                                   const std::vector<TextShaft>& shafts,
                                   const TextRoom& frame,
                                   double gap);

}  // namespace polhode
