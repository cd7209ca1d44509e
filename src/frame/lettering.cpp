// SPDX-License-Identifier: MIT
#include "frame/lettering.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr double kHalo = 0.075;  // of the font
constexpr double kShrink = 0.95;
constexpr double kSmallestType = 0.2;

}  // namespace

double type_size(double width, double height) {
  return std::min(height, std::sqrt(width * height * 9.0 / 16.0));
}

Rgb bytes_of(const glm::vec3& color) {
  const auto byte = [](float value) {
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
  };
  return {byte(color.r), byte(color.g), byte(color.b)};
}

TextStyle style_of(const Theme& theme, double size, const glm::vec3& color) {
  TextStyle style;
  style.size = size;
  style.color = bytes_of(color);
  style.halo = kHalo * size;
  style.halo_color = bytes_of(theme.background);
  return style;
}

TextStyle fitted(const Typesetter& typesetter,
                 const std::string& markup,
                 TextStyle style,
                 double width,
                 double height) {
  const double wanted = style.size;
  const auto fits = [&](double wrapped_at) {
    style.width = wrapped_at;
    const TextBox box = typesetter.measure(markup, style);
    return box.width <= width && box.height <= height;
  };
  while (!fits(0.0) && !fits(width) && style.size * kShrink >= kSmallestType * wanted) {
    style.size *= kShrink;
    style.halo *= kShrink;
  }
  return style;
}

}  // namespace polhode
