// SPDX-License-Identifier: MIT
// Pictures for SSIM, FLIP and the plain metrics, and what other implementations find on them.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "support/flat_image.h"

namespace polhode::test {

inline int floor_div(int a, int b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

// the pictures of tests/image/reference_metrics.py
inline Image scene(const std::string& kind) {
  constexpr int w = 96, h = 64;
  Image image(w, h);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const int u = kind == "shifted" ? x - 1 : x;
      int rgb[3] = {
          (37 + 3 * u + 2 * y) % 256, (90 + floor_div(u * y, 7)) % 256, (200 - 2 * u + y) % 256};
      const int disc[3] = {230, 180, 40};
      const int dx = u - w / 2, dy = y - h / 2;
      if (dx * dx + dy * dy < (h / 3) * (h / 3)) std::copy_n(disc, 3, rgb);
      if (kind == "tinted") rgb[0] += 4;
      if (kind == "noisy") {
        for (int& value : rgb)
          value += (x * 7 + y * 13) % 5 - 2;
      }
      if (kind == "hole" && std::abs(x - w / 4) < 4 && std::abs(y - h / 4) < 3)
        std::fill_n(rgb, 3, 0);
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<std::uint8_t>(std::clamp(rgb[c], 0, 255));
      image.at(x, y)[3] = 255;
    }
  }
  return image;
}

inline Image flat(int r, int g, int b, int alpha = 255, int side = 48) {
  return flat_image(side, side, r, g, b, alpha);
}

// What other implementations find between the plain picture and another.
struct Reference {
  const char* kind;
  int largest;
  double mean, rms, psnr, over_3, ssim, flip, worst_flip;
};

// printed by tests/image/reference_metrics.py: numpy, scikit-image 0.19, and FLIP from its formulas
inline const Reference kReferences[] = {
    // clang-format off
    {"shifted", 254, 5.100368924, 23.328745364, 20.7729760, 0.461263021, 0.8709196, 0.1758254, 0.790710},
    {"tinted", 4, 1.328016493, 2.303638238, 40.8825180, 0.993652344, 0.9999733, 0.0698505, 0.102816},
    {"noisy", 2, 1.197808160, 1.412716613, 45.1297026, 0.000000000, 0.9870199, 0.0099385, 0.039837},
    {"hole", 176, 0.861165365, 11.454258272, 26.9514642, 0.005696615, 0.9675619, 0.0087416, 0.973055},
    // clang-format on
};

inline void PrintTo(const Reference& row, std::ostream* out) {
  *out << row.kind;
}

inline auto references() {
  return testing::ValuesIn(kReferences);
}

inline std::string reference_name(const testing::TestParamInfo<Reference>& row) {
  return row.param.kind;
}

// Opaque noise, and the same with one pixel changed at (70, 100).
inline std::pair<Image, Image> noise_with_one_change() {
  Image a(150, 200);
  std::mt19937 random(7);
  for (std::uint8_t& value : a.pixels)
    value = static_cast<std::uint8_t>(random() & 255);
  for (std::size_t i = 3; i < a.pixels.size(); i += 4)
    a.pixels[i] = 255;
  Image b = a;
  b.at(70, 100)[1] = static_cast<std::uint8_t>(b.at(70, 100)[1] ^ 0x80);
  return {a, b};
}

}  // namespace polhode::test
