// SPDX-License-Identifier: MIT
#include "image/pixel_box.h"

#include <limits>

namespace polhode {
namespace {

// what `a` has and `b` has not
void add_rest(const PixelBox& a, const PixelBox& b, std::vector<PixelBox>& rest) {
  const PixelBox both = common(a, b);
  if (both.empty()) {
    rest.push_back(a);
    return;
  }
  for (const PixelBox& part : {
           PixelBox{a.x, a.y, a.width, both.y - a.y},
           PixelBox{a.x, both.bottom(), a.width, a.bottom() - both.bottom()},
           PixelBox{a.x, both.y, both.x - a.x, both.height},
           PixelBox{both.right(), both.y, a.right() - both.right(), both.height},
       }) {
    if (!part.empty()) rest.push_back(part);
  }
}

}  // namespace

std::vector<PixelBox> without(const PixelBox& a, const std::vector<PixelBox>& others) {
  std::vector<PixelBox> left = {a};
  for (const PixelBox& other : others) {
    std::vector<PixelBox> rest;
    for (const PixelBox& part : left)
      add_rest(part, other, rest);
    left = std::move(rest);
  }
  return left;
}

std::vector<PixelBox> in_bands(const std::vector<PixelBox>& boxes, int rows) {
  int top = std::numeric_limits<int>::max();
  int bottom = 0;
  for (const PixelBox& box : boxes) {
    top = std::min(top, box.y / rows * rows);
    bottom = std::max(bottom, box.bottom());
  }
  std::vector<PixelBox> bands;
  std::vector<PixelBox> here;
  for (int y = top; y < bottom; y += rows) {
    here.clear();
    for (const PixelBox& box : boxes) {
      const PixelBox part = common(box, {box.x, y, box.width, rows});
      if (!part.empty()) here.push_back(part);
    }
    // from left to right; those that overlap become one
    std::sort(
        here.begin(), here.end(), [](const PixelBox& a, const PixelBox& b) { return a.x < b.x; });
    const std::size_t first = bands.size();
    for (const PixelBox& part : here) {
      const bool joins = bands.size() > first && part.x <= bands.back().right();
      if (joins) {
        bands.back() = around(bands.back(), part);
      } else {
        bands.push_back(part);
      }
    }
  }
  return bands;
}

}  // namespace polhode
