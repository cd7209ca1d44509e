// SPDX-License-Identifier: MIT
#include "image/sprite.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

// a * b / 255, rounded
unsigned times(unsigned a, unsigned b) {
  const unsigned product = a * b + 128;
  return (product + (product >> 8)) >> 8;
}

// over a pixel of any alpha
void over(const std::uint8_t* source, unsigned opacity, std::uint8_t* pixel) {
  const unsigned alpha = times(source[3], opacity);
  if (alpha == 0) return;
  const unsigned behind = times(pixel[3], 255 - alpha);
  const unsigned together = alpha + behind;
  if (together == 255) {  // a constant divides faster
    for (int c = 0; c < 3; ++c) {
      const unsigned sum = 255 * times(source[c], opacity) + pixel[c] * behind;
      pixel[c] = static_cast<std::uint8_t>(std::min((sum + 127) / 255, 255u));
    }
    pixel[3] = 255;
    return;
  }
  for (int c = 0; c < 3; ++c) {
    const unsigned sum = 255 * times(source[c], opacity) + pixel[c] * behind;
    pixel[c] = static_cast<std::uint8_t>(std::min((sum + together / 2) / together, 255u));
  }
  pixel[3] = static_cast<std::uint8_t>(together);
}

}  // namespace

void lay_over(Image& picture, const Stamp& stamp) {
  const Sprite& sprite = *stamp.sprite;
  const int columns = stamp.columns < 0 ? sprite.width : std::min(stamp.columns, sprite.width);
  const int left = std::max(0, -stamp.x);
  const int right = std::min(columns, picture.width - stamp.x);
  const int top = std::max(0, -stamp.y);
  const int bottom = std::min(sprite.height, picture.height - stamp.y);
  const auto opacity = static_cast<unsigned>(std::lround(255.0 * stamp.opacity));
  if (picture.ground && left < right && top < bottom)
    picture.painted.push_back({stamp.x + left, stamp.y + top, right - left, bottom - top});
  for (int y = top; y < bottom; ++y) {
    const std::uint8_t* source =
        sprite.pixels.data() + 4 * (static_cast<std::size_t>(y) * sprite.width + left);
    std::uint8_t* pixel = picture.at(stamp.x + left, stamp.y + y);
    for (int x = left; x < right; ++x, source += 4, pixel += 4) {
      if (source[3] == 255 && opacity == 255) {
        std::copy_n(source, 4, pixel);  // most of a letter and its rim
      } else if (source[3] != 0) {
        over(source, opacity, pixel);
      }
    }
  }
}

Sprite sprite_of(const Image& image) {
  Sprite sprite(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    const unsigned alpha = image.pixels[i + 3];
    for (std::size_t c = 0; c < 3; ++c)
      sprite.pixels[i + c] = static_cast<std::uint8_t>(times(image.pixels[i + c], alpha));
    sprite.pixels[i + 3] = image.pixels[i + 3];
  }
  return sprite;
}

Sprite filled_sprite(int width,
                     int height,
                     const std::array<std::uint8_t, 3>& rgb,
                     double opacity) {
  Sprite sprite(width, height);
  const double alpha = std::clamp(opacity, 0.0, 1.0);
  for (std::size_t i = 0; i < sprite.pixels.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c)
      sprite.pixels[i + c] = static_cast<std::uint8_t>(std::lround(alpha * rgb[c]));
    sprite.pixels[i + 3] = static_cast<std::uint8_t>(std::lround(alpha * 255.0));
  }
  return sprite;
}

}  // namespace polhode
