// SPDX-License-Identifier: MIT
// Chooses over a whole film where each label stands beside its tip, so that it seldom changes its
// place, and never jumps where it can be seen.
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
  std::vector<TextShaft> shafts;  // of no length where they name no vector
  Obstacles obstacles;
  std::vector<TextShaft> curves = {};  // pieces of other lines, which may be covered if need be
  std::vector<Vec2> body = {};         // its convex outline, off which names of circles keep
};

// The sides on which a label may stand: in its wished direction, in directions of the picture near
// the point and a little farther, and on both sides of a head that ends there. Around an ellipse:
// in directions of the picture, each time a little farther.
inline constexpr int kLabelDirections = 16;
inline constexpr int kLabelSides = 1 + 2 * kLabelDirections + 2;
// The middle of a label on that side, 0 <= side < kLabelSides.
Vec2 center_on(const LabelWish& wish, int side, double gap);
// The point of what it names with which a label on that side moves.
Vec2 anchor_on(const LabelWish& wish, int side);

// Where a label stands.
struct LabelPlace {
  Vec2 center;           // px
  double opacity = 1.0;  // it fades while it changes its place
};

// The place of each label at each of a film's moments. Immutable.
class LabelTracks {
 public:
  // Each label in turn takes the places, a side or the nearest that is free, at which it covers
  // least (curves count less than shafts, these less than heads, text and labels), is not beside
  // or beyond another vector, and stands nearest to its wish; every change has its price.
  // `frame`: where labels may stand; `gap`: what is free around them, pixels.
  LabelTracks(const std::vector<LabelMoment>& moments, const TextRoom& frame, double gap);

  // The place of a label at the time `at`, in units of the step between moments. Within
  // kMomentsOfFade moments of a change it is fainter, and invisible when it changes.
  LabelPlace place(const std::string& name, const LabelWish& wish, double at) const;
  static constexpr double kMomentsOfFade = 1.5;

 private:
  // Where a label is at one moment.
  struct Stay {
    bool is_there = false;
    int side = 0;
    Vec2 offset = Vec2::Zero();  // of its middle from anchor_on() that side, px

    Vec2 center(const LabelWish& wish) const { return anchor_on(wish, side) + offset; }
    bool changes_after = false;  // the next moment has another place
  };
  std::vector<Stay> cheapest(const std::vector<LabelMoment>& moments,
                             const std::string& name,
                             const std::vector<std::vector<TextRoom>>& labels,
                             const TextRoom& frame) const;

  double gap_;
  std::map<std::string, std::vector<Stay>> tracks_;
};

}  // namespace polhode
