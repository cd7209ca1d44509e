// SPDX-License-Identifier: MIT
#include "image/pixel_box.h"

namespace polhode {

std::vector<PixelBox> without(const PixelBox& a, const PixelBox& b) {
  const PixelBox both = common(a, b);
  if (both.empty()) return {a};
  std::vector<PixelBox> rest = {
      {a.x, a.y, a.width, both.y - a.y},
      {a.x, both.bottom(), a.width, a.bottom() - both.bottom()},
      {a.x, both.y, both.x - a.x, both.height},
      {both.right(), both.y, a.right() - both.right(), both.height},
  };
  std::erase_if(rest, [](const PixelBox& box) { return box.empty(); });
  return rest;
}

std::vector<PixelBox> merged(std::vector<PixelBox> boxes) {
  std::vector<PixelBox> apart;
  while (!boxes.empty()) {
    PixelBox box = boxes.back();
    boxes.pop_back();
    const auto overlaps = [&](const PixelBox& other) {
      return !common(box, other).empty();
    };
    // a box that grows may reach others that it did not
    for (auto other = apart.begin(); other != apart.end();) {
      if (overlaps(*other)) {
        box = around(box, *other);
        apart.erase(other);
        other = apart.begin();
      } else {
        ++other;
      }
    }
    apart.push_back(box);
  }
  return apart;
}

}  // namespace polhode
