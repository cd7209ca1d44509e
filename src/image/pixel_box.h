// SPDX-License-Identifier: MIT
// Rectangles of pixels and operations on them.
#pragma once

#include <algorithm>
#include <vector>

namespace polhode {

// Pixels [x, right()) x [y, bottom()), rows counted from the top. Empty if width or height is not
// positive.
struct PixelBox {
  int x = 0, y = 0;           // of the upper left pixel
  int width = 0, height = 0;  // pixels

  int right() const { return x + width; }
  int bottom() const { return y + height; }
  bool empty() const { return width <= 0 || height <= 0; }
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

// The intersection; empty if the boxes have no common pixel.
inline PixelBox common(const PixelBox& a, const PixelBox& b) {
  const int x = std::max(a.x, b.x);
  const int y = std::max(a.y, b.y);
  return {x, y, std::min(a.right(), b.right()) - x, std::min(a.bottom(), b.bottom()) - y};
}

// The smallest box that contains both, neither of which may be empty.
inline PixelBox around(const PixelBox& a, const PixelBox& b) {
  const int x = std::min(a.x, b.x);
  const int y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

// The part of `a` outside all of `others`, as boxes that do not overlap.
std::vector<PixelBox> without(const PixelBox& a, const std::vector<PixelBox>& others);

// Boxes that do not overlap and cover all of `boxes` (with x, y >= 0) and little more. Each lies
// within one band of `rows` rows (positive), counted from row 0; boxes of a band that overlap or
// touch sideways become one.
std::vector<PixelBox> in_bands(const std::vector<PixelBox>& boxes, int rows);

}  // namespace polhode
