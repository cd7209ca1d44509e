// SPDX-License-Identifier: MIT
#include "image/sprite.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/color.h"

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

constexpr double kContrastOfInk = 5.2;

// relative luminance of encoded values (WCAG 2.1)
float luminance(const std::uint8_t* rgb) {
  static const std::array<float, 256> linear = [] {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
      table[i] = static_cast<float>(linear_of_srgb(static_cast<double>(i) / 255.0));
    return table;
  }();
  return 0.2126F * linear[rgb[0]] + 0.7152F * linear[rgb[1]] + 0.0722F * linear[rgb[2]];
}

// the encoded value of the grey with that luminance, 0..255
double grey_of(double luminance) {
  const double y = std::clamp(luminance, 0.0, 1.0);
  return 255.0 * (y <= 0.00304 ? 12.92 * y : 1.055 * std::pow(y, 1.0 / 2.4) - 0.055);
}

// How much of its rim a pixel needs. Mixed greys stand for mixed colours, which are never lighter.
class RimNeed {
 public:
  explicit RimNeed(const Rim& rim) : rim_(grey_of(luminance(rim.color.data()))) {
    const double ink = luminance(rim.ink.data()) + 0.05;
    is_dark_ = luminance(rim.color.data()) + 0.05 < ink;
    limit_ = (is_dark_ ? ink / kContrastOfInk : ink * kContrastOfInk) - 0.05;
    target_ = grey_of(limit_);
  }
  // 0..255
  unsigned at(const std::uint8_t* pixel) const {
    if (pixel[3] < 255) return 255;
    const double found = luminance(pixel);
    if (is_dark_ ? found <= limit_ : found >= limit_) return 0;
    const double grey = grey_of(found);
    const double part = (grey - target_) / (grey - rim_);
    if (!(part < 1.0)) return 255;
    if (part < 0.0) return 0;  // it stands out from the ink more than the rim does
    return static_cast<unsigned>(std::ceil(255.0 * part));
  }

 private:
  double rim_ = 0.0;  // greys
  double limit_ = 0.0, target_ = 0.0;
  bool is_dark_ = true;
};

// the rim of a sprite over the rows and columns of the picture on which it lies
void lay_rim(Image& picture, const Stamp& stamp, const PixelBox& box, unsigned opacity) {
  const Sprite& sprite = *stamp.sprite;
  const Rim& rim = sprite.rim;
  const RimNeed need(rim);
  for (int y = box.y; y < box.y + box.height; ++y) {
    const std::uint8_t* covered = rim.coverage.data() +
                                  static_cast<std::size_t>(y - stamp.y) * sprite.width +
                                  (box.x - stamp.x);
    std::uint8_t* pixel = picture.at(box.x, y);
    for (int x = 0; x < box.width; ++x, ++covered, pixel += 4) {
      if (*covered == 0) continue;
      const unsigned alpha = times(*covered, need.at(pixel));
      if (alpha == 0) continue;
      std::array<std::uint8_t, 4> source{};
      for (std::size_t c = 0; c < 3; ++c)
        source[c] = static_cast<std::uint8_t>(times(rim.color[c], alpha));
      source[3] = static_cast<std::uint8_t>(alpha);
      over(source.data(), opacity, pixel);
    }
  }
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
  if (left >= right || top >= bottom) return;
  const PixelBox box{stamp.x + left, stamp.y + top, right - left, bottom - top};
  if (picture.ground) picture.painted.push_back(box);
  if (!sprite.rim.coverage.empty()) lay_rim(picture, stamp, box, opacity);
  for (int y = top; y < bottom; ++y) {
    const std::uint8_t* source =
        sprite.pixels.data() + 4 * (static_cast<std::size_t>(y) * sprite.width + left);
    std::uint8_t* pixel = picture.at(stamp.x + left, stamp.y + y);
    for (int x = left; x < right; ++x, source += 4, pixel += 4) {
      if (source[3] == 255 && opacity == 255) {
        std::copy_n(source, 4, pixel);  // most of a letter
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
