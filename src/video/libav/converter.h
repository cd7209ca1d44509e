// SPDX-License-Identifier: MIT
// Pictures to the pixels that an encoder takes. Not for other libraries.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "image/image.h"
#include "video/libav/libav.h"

namespace polhode {

// Full-range RGB to limited-range BT.709 where the format is YUV; alpha stays straight, and is
// dropped where the format has none. Only what may differ from the picture before is converted.
class Converter {
 public:
  // Throws Error (environment) when swscale cannot.
  Converter(int width, int height, AVPixelFormat format);

  // The frame is this object's own and holds until the next call; its time is the caller's to set.
  AVFrame* convert(const Image& image);

 private:
  std::vector<PixelBox> to_convert(const Image& image) const;
  SwsContext& scaler_for(int width, int height);
  void convert_box(const Image& image, const PixelBox& box, AVFrame& frame);
  void convert_part(const Image& image, const PixelBox& box);

  Owned<AVFrame> frame_;
  Owned<AVFrame> part_;                                       // a piece of it with its surroundings
  std::map<std::pair<int, int>, Owned<SwsContext>> scalers_;  // by width and height
  // what frame_ shows outside these boxes
  std::optional<std::array<std::uint8_t, 4>> ground_;
  std::vector<PixelBox> painted_;
};

}  // namespace polhode
