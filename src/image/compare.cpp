// SPDX-License-Identifier: MIT
#include "image/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/error.h"

namespace polhode {
namespace {

void refuse_sizes(const Image& a, const Image& b) {
  if (a.width == b.width && a.height == b.height) return;
  throw input_error(
      "the pictures have different sizes: {}x{} and {}x{}", a.width, a.height, b.width, b.height);
}

}  // namespace

Difference compare(const Image& a, const Image& b, int threshold) {
  refuse_sizes(a, b);
  Difference difference;
  std::size_t over = 0;
  double sum = 0.0, squares = 0.0;
  for (std::size_t pixel = 0; pixel < a.pixels.size(); pixel += 4) {
    int worst = 0;
    for (std::size_t c = pixel; c < pixel + 4; ++c) {
      const int apart = std::abs(a.pixels[c] - b.pixels[c]);
      worst = std::max(worst, apart);
      sum += apart;
      squares += static_cast<double>(apart) * apart;
    }
    difference.largest = std::max(difference.largest, worst);
    over += worst > threshold ? 1 : 0;
  }
  if (!a.pixels.empty()) {
    difference.mean = sum / static_cast<double>(a.pixels.size());
    difference.rms = std::sqrt(squares / static_cast<double>(a.pixels.size()));
    difference.fraction_over =
        4.0 * static_cast<double>(over) / static_cast<double>(a.pixels.size());
  }
  return difference;
}

Image difference_picture(const Image& a, const Image& b, int gain) {
  refuse_sizes(a, b);
  Image out(a.width, a.height);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const bool alpha = i % 4 == 3;
    const int value = alpha ? 255 : gain * std::abs(a.pixels[i] - b.pixels[i]);
    out.pixels[i] = static_cast<std::uint8_t>(std::min(255, value));
  }
  return out;
}

}  // namespace polhode
