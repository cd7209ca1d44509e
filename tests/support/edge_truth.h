// SPDX-License-Identifier: MIT
// What the edges of a picture should look like, and how far a picture is from that.
#pragma once

#include <vector>

#include "render/renderer.h"

namespace polhode::test {

// The mean of 64 pictures without smoothing, each a part of a pixel aside: four values a pixel.
inline std::vector<double> edge_truth(const Context& context,
                                      const Picture& picture,
                                      int width,
                                      int height) {
  constexpr int kSide = 8;  // pictures along each side of a pixel
  Renderer renderer(context, {width, height, 0, false, Edges::samples});
  std::vector<double> mean(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  Image image;
  for (int k = 0; k < kSide * kSide; ++k) {
    Picture moved = picture;
    for (Panel& panel : moved.panels) {
      glm::mat4 aside(1.0f);
      aside[3][0] = 2.0f * ((k % kSide + 0.5f) / kSide - 0.5f) / panel.place.width;
      aside[3][1] = 2.0f * ((k / kSide + 0.5f) / kSide - 0.5f) / panel.place.height;
      panel.list.view.clip_from_world = aside * panel.list.view.clip_from_world;
    }
    renderer.draw(moved, image);
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += image.pixels[i] / static_cast<double>(kSide * kSide);
  }
  return mean;
}

// Of the colours of an opaque picture, in squares of levels of 0..255.
inline double mean_square_error(const Image& image, const std::vector<double>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double off = i % 4 == 3 ? 0.0 : image.pixels[i] - truth[i];
    sum += off * off;
  }
  return sum / (0.75 * static_cast<double>(truth.size()));
}

}  // namespace polhode::test
