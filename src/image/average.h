// SPDX-License-Identifier: MIT
// The mean of several pictures, as an open shutter sees them.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace polhode {

// Sums light: colours are averaged as squares of their stored values, close to what a sensor does
// with the light that sRGB stands for; alpha as it is, and colours by their alpha.
class AveragePicture {
 public:
  void add(const Image& image);
  // What was added since the last mean(), at least one; begins anew.
  void mean(Image& image);

 private:
  int width_ = 0, height_ = 0;
  std::uint32_t count_ = 0;
  std::vector<std::uint64_t> light_;  // per value, squares times alpha; alpha itself in the fourth
};

}  // namespace polhode
