// SPDX-License-Identifier: MIT
// Small pictures that are drawn over a frame: text and plots.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "image/image.h"

namespace polhode {

// What lies around letters, below them: where the picture differs too little from their ink, it is
// mixed with `color` until the contrast is 5.2 : 1 (WCAG 2.1), or as far as that goes.
struct Rim {
  std::array<std::uint8_t, 3> color{};  // sRGB
  std::array<std::uint8_t, 3> ink{};    // sRGB
  std::vector<std::uint8_t> coverage;   // of each pixel, 0..255; empty: there is no rim
};

// 8-bit RGBA, sRGB-encoded colour premultiplied by alpha, rows from top to bottom, without padding:
// pixels.size() == 4 * width * height.
struct Sprite {
  int width = 0;   // pixels
  int height = 0;  // pixels
  std::vector<std::uint8_t> pixels;
  Rim rim = {};

  Sprite() = default;
  // Transparent.
  Sprite(int w, int h)
      : width(w),
        height(h),
        pixels(4 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
};
using SpritePtr = std::shared_ptr<const Sprite>;

// A sprite at its position in a picture.
struct Stamp {
  SpritePtr sprite;      // not null when drawn
  int x = 0, y = 0;      // pixels: position of its upper left pixel; may lie outside the picture
  double opacity = 1.0;  // 0..1
  int columns = -1;      // how many columns from the left are shown; negative or too many: all
};

// Composites the stamp, its rim first, over a picture with straight alpha (Porter-Duff "over", on
// encoded values) and clips it at the borders. Where the picture is transparent the rim is whole.
// Adds the changed box to picture.painted if the picture has a ground.
void lay_over(Image& picture, const Stamp& stamp);

// The picture as a sprite, with its alpha premultiplied.
Sprite sprite_of(const Image& image);

// A sprite of one sRGB colour and one opacity (0..1).
Sprite filled_sprite(int width, int height, const std::array<std::uint8_t, 3>& rgb, double opacity);

}  // namespace polhode
