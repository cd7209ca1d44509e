// SPDX-License-Identifier: MIT
#include "export/mark_picture.h"

#include <algorithm>
#include <cmath>

#include "image/png.h"

namespace polhode {

namespace {
constexpr int kMarkPixels = 512;
}  // namespace

std::string mark_picture(const Material& look, double reach) {
  Image image(kMarkPixels, kMarkPixels);
  const glm::vec3 shade(0.54f, 0.71f, 0.90f);
  const double texel = 2.0 * reach / kMarkPixels;
  for (int row = 0; row < kMarkPixels; ++row) {
    for (int column = 0; column < kMarkPixels; ++column) {
      const double x = (column + 0.5) * texel - reach, y = reach - (row + 0.5) * texel;
      const auto front = static_cast<float>(std::clamp(x / texel + 0.5, 0.0, 1.0));
      const double inside = (static_cast<double>(look.mark_width) - std::abs(y)) / texel;
      const float strip = static_cast<float>(std::clamp(inside + 0.5, 0.0, 1.0)) * front;
      const glm::vec3 half = look.color * (shade + front * (glm::vec3(1.0f) - shade));
      const glm::vec3 color = half + strip * (look.mark_color - half);
      for (int i = 0; i < 3; ++i)
        image.at(column, row)[i] = static_cast<std::uint8_t>(std::lround(255.0f * color[i]));
    }
  }
  return encode_png(image, false);
}

}  // namespace polhode
