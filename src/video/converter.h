// SPDX-License-Identifier: MIT
// Pictures to the pixels that an encoder takes. Not for other rooms.
#pragma once

#include "image/image.h"
#include "video/libav.h"

namespace polhode {

// Full-range RGB to limited-range BT.709 where the format is YUV; alpha stays straight, and is
// dropped where the format has none.
class Converter {
 public:
  // Throws Error (environment) when swscale cannot.
  Converter(int width, int height, AVPixelFormat format);

  // The frame is this object's own and holds until the next call; its time is the caller's to set.
  AVFrame* convert(const Image& image);

 private:
  Owned<AVFrame> frame_;
  Owned<SwsContext> scaler_;
};

}  // namespace polhode
