// SPDX-License-Identifier: MIT
// A picture of one colour.
#pragma once

#include "image/image.h"

namespace polhode::test {

inline Image flat_image(int width, int height, int r, int g, int b, int alpha = 255) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    image.pixels[i] = static_cast<std::uint8_t>(r);
    image.pixels[i + 1] = static_cast<std::uint8_t>(g);
    image.pixels[i + 2] = static_cast<std::uint8_t>(b);
    image.pixels[i + 3] = static_cast<std::uint8_t>(alpha);
  }
  return image;
}

}  // namespace polhode::test
