// SPDX-License-Identifier: MIT
// A chevron at the edge of a picture, which points to a body outside it.
#pragma once

#include "frame/labels.h"
#include "image/sprite.h"
#include "text/typesetter.h"

namespace polhode {

// Two lines that meet at a right angle. Pixels, y down.
struct Chevron {
  Vec2 tip;
  Vec2 way;           // unit vector in which it points
  double size = 0.0;  // how far its ends are behind the tip, and to both sides of it

  Vec2 left_end() const { return tip - size * (way + Vec2(-way.y(), way.x())); }
  Vec2 right_end() const { return tip - size * (way - Vec2(-way.y(), way.x())); }
  // The rectangle around its lines.
  TextRoom room() const;
};

// The chevron that stands where the ray from the middle of a rectangle in the direction `way` (unit
// vector) leaves it, but wholly inside. size: see Chevron, at most a third of the rectangle.
Chevron chevron_in(const TextRoom& frame, const Vec2& way, double size);

// Its picture, in the colour of the style and with the style's rim.
Stamp stamp_of(const Chevron& chevron, const TextStyle& style);

}  // namespace polhode
