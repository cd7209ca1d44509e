// SPDX-License-Identifier: MIT
// A picture in memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "image/pixel_box.h"

namespace polhode {

// 8-bit RGBA, rows from top to bottom, no padding between rows, straight (not premultiplied) alpha,
// sRGB-encoded colour (BT.709 primaries). pixels.size() == 4 * width * height.
struct Image {
  int width = 0;   // pixels
  int height = 0;  // pixels
  std::vector<std::uint8_t> pixels;
  // What is known of the picture, so that nobody does work for pixels that are as they were: with a
  // ground, every pixel outside the painted boxes has its colour; without one, nothing is known.
  std::optional<std::array<std::uint8_t, 4>> ground;
  std::vector<PixelBox> painted;

  Image() = default;
  Image(int w, int h)
      : width(w),
        height(h),
        pixels(4 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  // The four bytes of the pixel in column x, row y.
  const std::uint8_t* at(int x, int y) const {
    return pixels.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                static_cast<std::size_t>(x));
  }
  std::uint8_t* at(int x, int y) {
    return const_cast<std::uint8_t*>(std::as_const(*this).at(x, y));
  }

  // Makes all of it one colour, and that its ground; but for `kept`, which will be painted over,
  // every pixel of it, and may be left as it is.
  void wipe(int w,
            int h,
            const std::array<std::uint8_t, 4>& color,
            const std::vector<PixelBox>& kept = {});
  // One colour in a box within it; the ground stays.
  void fill(const PixelBox& box, const std::array<std::uint8_t, 4>& color);
};

}  // namespace polhode
