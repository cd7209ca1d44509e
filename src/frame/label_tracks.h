// SPDX-License-Identifier: MIT
// Chooses over a whole film on which side of its tip each label stands, so that it seldom changes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "frame/labels.h"

namespace polhode {

// The labels of a panel at one moment, before they are placed; pixels, y down.
struct LabelMoment {
  std::vector<std::string> names;  // of the labels, each only once
  std::vector<LabelWish> wishes;
  std::vector<TextShaft> shafts;
  Obstacles obstacles;
};

// The sides on which a label may stand: in its wished direction, and in directions of the picture
// near the point and a little farther.
inline constexpr int kLabelSides = 17;
// The middle of a label on that side, 0 <= side < kLabelSides.
Vec2 center_on(const LabelWish& wish, int side, double gap);

// The side of each label at each of a film's moments. Immutable.
class LabelTracks {
 public:
  // Each label in turn takes the sides on which it covers least (shafts count less than heads,
  // text and labels) and stands nearest to its wish, where each change of sides has its price.
  // `frame`: where labels may stand; `gap`: what is free around them, pixels.
  LabelTracks(const std::vector<LabelMoment>& moments, const TextRoom& frame, double gap);

  // Where the label wishes to stand at the time `at`, in units of the step between moments: on the
  // way from side to side it glides.
  Vec2 center(const std::string& name, const LabelWish& wish, double at) const;

 private:
  using Sides = std::vector<int>;  // of a label at each moment; kAbsent where there is none
  double gap_;
  std::map<std::string, Sides> tracks_;
};

}  // namespace polhode
