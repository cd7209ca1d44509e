// SPDX-License-Identifier: MIT
// The picture type that rendering produces and sinks and metrics read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "image/pixel_box.h"

namespace polhode {

// 8-bit RGBA, rows from top to bottom, no padding between rows, straight (not premultiplied) alpha,
// sRGB-encoded colour (BT.709 primaries). pixels.size() == 4 * width * height.
struct Image {
  int width = 0;   // pixels
  int height = 0;  // pixels
  std::vector<std::uint8_t> pixels;
  // Lets later stages skip unchanged pixels: if `ground` is set, every pixel outside the `painted`
  // boxes has that colour. If not, nothing is known about the pixels.
  std::optional<std::array<std::uint8_t, 4>> ground;
  std::vector<PixelBox> painted;

  Image() = default;
  // Transparent black, without ground.
  Image(int w, int h)
      : width(w),
        height(h),
        pixels(4 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  // The four bytes (R, G, B, A) of the pixel in column x and row y, which must lie in the picture;
  // valid until `pixels` is resized. The row follows without a gap.
  const std::uint8_t* at(int x, int y) const {
    return pixels.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                static_cast<std::size_t>(x));
  }
  std::uint8_t* at(int x, int y) {
    return const_cast<std::uint8_t*>(std::as_const(*this).at(x, y));
  }

  // Sets the size to w x h, fills the picture with one colour (R, G, B, A), makes that its ground,
  // and empties `painted`. The boxes in `kept` may be left as they are: the caller will overwrite
  // every pixel in them.
  void wipe(int w,
            int h,
            const std::array<std::uint8_t, 4>& color,
            const std::vector<PixelBox>& kept = {});
  // Fills a box, which must lie inside the picture, with one colour (R, G, B, A). Does not change
  // `ground` and `painted`.
  void fill(const PixelBox& box, const std::array<std::uint8_t, 4>& color);
};

// The rest of the work on an image, for whichever thread has time. Call it once, with the image
// that it was made for. Empty: there is nothing left to do.
using Retouch = std::function<void(Image&)>;

}  // namespace polhode
