// SPDX-License-Identifier: MIT
// Small pictures that are laid over others: text, plots.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "image/image.h"

namespace polhode {

// 8-bit RGBA with premultiplied alpha, rows from top to bottom, as compositing wants it.
struct Sprite {
  int width = 0;   // pixels
  int height = 0;  // pixels
  std::vector<std::uint8_t> pixels;

  Sprite() = default;
  Sprite(int w, int h)
      : width(w),
        height(h),
        pixels(4 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
};
using SpritePtr = std::shared_ptr<const Sprite>;

// A sprite in its place.
struct Stamp {
  SpritePtr sprite;
  int x = 0, y = 0;      // of its upper left pixel in the picture; may lie outside
  double opacity = 1.0;  // 0..1
  int columns = -1;      // only so many from the left are shown; -1: all
};

// Source over: lays the stamp over a picture of straight alpha; what lies outside is cut off.
void lay_over(Image& picture, const Stamp& stamp);

// A picture as a sprite.
Sprite sprite_of(const Image& image);

// A sprite of one colour.
Sprite filled_sprite(int width, int height, const std::array<std::uint8_t, 3>& rgb, double opacity);

}  // namespace polhode
