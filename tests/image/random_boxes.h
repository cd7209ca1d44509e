// SPDX-License-Identifier: MIT
// Boxes of pixels anywhere in a small picture.
#pragma once

#include <random>
#include <vector>

#include "image/pixel_box.h"

namespace polhode::test {

inline constexpr int kSide = 24;

// that many boxes within kSide by kSide pixels, each of at least one pixel
inline std::vector<PixelBox> random_boxes(std::mt19937& random, int count) {
  std::vector<PixelBox> boxes;
  const auto below = [&](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most));
  };
  for (int i = 0; i < count; ++i) {
    const int x = below(kSide - 1);
    const int y = below(kSide - 1);
    boxes.push_back({x, y, 1 + below(kSide - x - 1), 1 + below(kSide - y - 1)});
  }
  return boxes;
}

}  // namespace polhode::test
