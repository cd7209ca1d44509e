// SPDX-License-Identifier: MIT
// Draws smooth lines, whole or dashed, on sprites.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/sprite.h"

namespace polhode {

// A point in pixels from the upper left corner of a sprite, x to the right, y down; the middle of
// the first pixel is (0.5, 0.5).
struct LinePoint {
  double x = 0.0, y = 0.0;
};
using Polyline = std::vector<LinePoint>;

// The pieces of a line that a dash pattern leaves: lengths in pixels, drawn and left out in turn,
// all positive, measured along the line from its first point, so that a dash goes on round the
// corners of the line. An empty pattern gives the whole line.
std::vector<Polyline> dashes_of(const Polyline& line, const std::vector<double>& pattern);

// Draws lines of one sRGB colour over a sprite, with round ends, corners and smooth edges; `width`
// in pixels. Where the lines meet or cross, they are not drawn twice. A line of one point is a
// disc.
void stroke(Sprite& sprite,
            const std::vector<Polyline>& lines,
            double width,
            const std::array<std::uint8_t, 3>& rgb);

}  // namespace polhode
