// SPDX-License-Identifier: MIT
// Rectangles of pixels.
#pragma once

#include <algorithm>
#include <vector>

namespace polhode {

// Rows count from the top; empty when it holds no pixel.
struct PixelBox {
  int x = 0, y = 0;
  int width = 0, height = 0;

  int right() const { return x + width; }
  int bottom() const { return y + height; }
  bool empty() const { return width <= 0 || height <= 0; }
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

// What both hold.
inline PixelBox common(const PixelBox& a, const PixelBox& b) {
  const int x = std::max(a.x, b.x);
  const int y = std::max(a.y, b.y);
  return {x, y, std::min(a.right(), b.right()) - x, std::min(a.bottom(), b.bottom()) - y};
}

// The least box that holds both.
inline PixelBox around(const PixelBox& a, const PixelBox& b) {
  const int x = std::min(a.x, b.x);
  const int y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

// What `a` has and none of `others` has, in boxes that do not overlap.
std::vector<PixelBox> without(const PixelBox& a, const std::vector<PixelBox>& others);

// All that the boxes hold and little more, in boxes that do not overlap: each lies in one band of
// so many rows, counted from row 0.
std::vector<PixelBox> in_bands(const std::vector<PixelBox>& boxes, int rows);

}  // namespace polhode
