// SPDX-License-Identifier: MIT
#include "image/average.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace polhode {

void AveragePicture::add(const Image& image) {
  if (count_ == 0) {
    width_ = image.width;
    height_ = image.height;
    light_.assign(image.pixels.size(), 0);
  }
  CHECK(image.width == width_ && image.height == height_);
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    const std::uint64_t alpha = image.pixels[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint64_t value = image.pixels[i + c];
      light_[i + c] += value * value * alpha;
    }
    light_[i + 3] += alpha;
  }
  ++count_;
}

void AveragePicture::mean(Image& image) {
  CHECK(count_ > 0);
  if (image.width != width_ || image.height != height_) image = Image(width_, height_);
  image.ground.reset();
  for (std::size_t i = 0; i < light_.size(); i += 4) {
    const std::uint64_t alpha = light_[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      const double light =
          alpha > 0 ? static_cast<double>(light_[i + c]) / static_cast<double>(alpha) : 0.0;
      image.pixels[i + c] = static_cast<std::uint8_t>(std::lround(std::sqrt(light)));
    }
    image.pixels[i + 3] = static_cast<std::uint8_t>((alpha + count_ / 2) / count_);
  }
  count_ = 0;
}

}  // namespace polhode
