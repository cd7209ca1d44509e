// SPDX-License-Identifier: MIT
#include "image/pixel_box.h"

namespace polhode {

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
