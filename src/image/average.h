// SPDX-License-Identifier: MIT
// Averages pictures in linear light, for motion blur.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace polhode {

// Averages the squares of the colour values, weighted by alpha, and takes the root: a gamma of 2,
// close to sRGB. Alpha itself is averaged linearly. Not thread-safe.
class AveragePicture {
 public:
  // Adds one picture. All pictures of an average must have the same size.
  void add(const Image& image);
  // Stores the mean of the pictures added since the last call (at least one) in `image`, whose size
  // is changed to theirs and whose `ground` is unset, and starts a new average.
  void mean(Image& image);

 private:
  int width_ = 0, height_ = 0;
  std::uint32_t count_ = 0;
  std::vector<std::uint64_t> light_;  // four sums per pixel: squared colour times alpha, and alpha
};

}  // namespace polhode
