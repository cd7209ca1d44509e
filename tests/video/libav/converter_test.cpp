// SPDX-License-Identifier: MIT
#include "video/libav/converter.h"

extern "C" {
#include <libavutil/imgutils.h>
}

#include <random>

#include <gtest/gtest.h>

namespace polhode {
namespace {

// a ground with boxes of noise
Image picture(int width, int height, int moment) {
  std::mt19937 random(static_cast<unsigned>(moment) + 1);
  Image image;
  image.wipe(width, height, {16, 20, 28, 255});
  for (int k = 0; k < 3; ++k) {
    const int w = 1 + static_cast<int>(random() % 150);
    const int h = 1 + static_cast<int>(random() % 150);
    const PixelBox box{static_cast<int>(random() % static_cast<unsigned>(width - w)),
                       static_cast<int>(random() % static_cast<unsigned>(height - h)),
                       w,
                       h};
    for (int y = box.y; y < box.bottom(); ++y) {
      for (int x = box.x; x < box.right(); ++x) {
        for (int c = 0; c < 3; ++c)
          image.at(x, y)[c] = static_cast<std::uint8_t>(random());
      }
    }
    image.painted.push_back(box);
  }
  return image;
}

std::vector<std::uint8_t> bytes_of(const AVFrame& frame) {
  const AVPixFmtDescriptor& kind = *av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
  std::vector<std::uint8_t> bytes;
  for (int plane = 0; plane < 4 && frame.data[plane] != nullptr; ++plane) {
    const bool color = plane == 1 || plane == 2;
    const int rows = color ? AV_CEIL_RSHIFT(frame.height, kind.log2_chroma_h) : frame.height;
    const int columns =
        av_image_get_linesize(static_cast<AVPixelFormat>(frame.format), frame.width, plane);
    for (int y = 0; y < rows; ++y) {
      const std::uint8_t* row = frame.data[plane] + y * frame.linesize[plane];
      bytes.insert(bytes.end(), row, row + columns);
    }
  }
  return bytes;
}

// a film's frames, of which only boxes are converted, are the same as each converted as a whole
TEST(Converter, BoxesGiveTheSamePixelsAsTheWhole) {
  for (const AVPixelFormat format : {AV_PIX_FMT_YUV420P,
                                     AV_PIX_FMT_YUVA420P,
                                     AV_PIX_FMT_YUV444P,
                                     AV_PIX_FMT_YUVA444P10LE,
                                     AV_PIX_FMT_RGBA,
                                     AV_PIX_FMT_GBRP}) {
    Converter film(640, 362, format);
    for (int moment = 0; moment < 6; ++moment) {
      const Image now = picture(640, 362, moment);
      Image unknown = now;
      unknown.ground.reset();
      Converter whole(640, 362, format);
      ASSERT_EQ(bytes_of(*film.convert(now)), bytes_of(*whole.convert(unknown)))
          << av_get_pix_fmt_name(format) << ' ' << moment;
    }
  }
}

}  // namespace
}  // namespace polhode
