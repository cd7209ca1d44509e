// SPDX-License-Identifier: MIT
// Converts pictures to the pixel format of an encoder. Private to video/.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "image/image.h"
#include "video/libav/libav.h"

namespace polhode {

// Converts full-range sRGB; YUV formats get limited-range BT.709. Alpha stays straight, and is
// dropped if the format has none. In YUV formats, only the parts that may differ from the previous
// picture, by Image::ground and Image::painted (image/image.h), are converted. Not thread-safe.
class Converter {
 public:
  // Sizes in pixels. Throws Error (environment), without a place, if swscale does not support the
  // format and without memory.
  Converter(int width, int height, AVPixelFormat format);

  // The converted frame, owned by this object and valid until the next call. The picture has the
  // size of the converter. The caller sets the frame's pts. Throws Error (environment) as
  // check_libav does.
  AVFrame* convert(const Image& image);

 private:
  std::vector<PixelBox> to_convert(const Image& image) const;
  SwsContext& scaler_for(int width, int height);
  void convert_box(const Image& image, const PixelBox& box, AVFrame& frame);
  void convert_part(const Image& image, const PixelBox& box);

  Owned<AVFrame> frame_;
  Owned<AVFrame> part_;                                       // a part of it with a border
  std::map<std::pair<int, int>, Owned<SwsContext>> scalers_;  // by width and height
  // the colour of frame_ outside the boxes
  std::optional<std::array<std::uint8_t, 4>> ground_;
  std::vector<PixelBox> painted_;
};

}  // namespace polhode
