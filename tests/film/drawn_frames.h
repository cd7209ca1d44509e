// SPDX-License-Identifier: MIT
// A renderer without OpenGL, whose frames tell their number.
#pragma once

#include <vector>

#include "film/frame_renderer.h"

namespace polhode::test {

// Frame i is one colour, with its red level i.
class NumberedFrames : public FrameRenderer {
 public:
  explicit NumberedFrames(PictureSize size) : size_(size) {
    info_ = {"paper", "by hand", "0.1", 3, true};
  }

  void render(int index, Image& image) override {
    image.wipe(size_.width, size_.height, {static_cast<std::uint8_t>(index), 20, 30, 255});
    image.painted.clear();
    drawn.push_back(index);
  }
  const RendererInfo& info() const override { return info_; }
  DrawingTimes times() const override {
    const double frames = static_cast<double>(drawn.size());
    return {
        {1.0 * frames, 2.0 * frames},
        {{3.0 * frames, 4.0 * frames}, {5.0 * frames, 6.0 * frames}, {7.0 * frames, 8.0 * frames}}};
  }

  std::vector<int> drawn;  // in their order

 private:
  PictureSize size_;
  RendererInfo info_;
};

// The number of such a frame, if all of it has its colour; else -1.
inline int number_of(const Image& image) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* pixel = image.at(x, y);
      if (pixel[0] != image.at(0, 0)[0] || pixel[1] != 20 || pixel[2] != 30 || pixel[3] != 255)
        return -1;
    }
  }
  return image.pixels.empty() ? -1 : image.at(0, 0)[0];
}

}  // namespace polhode::test
