// SPDX-License-Identifier: MIT
#include "video/converter.h"

#include <utility>
#include <vector>

#include "base/check.h"

namespace polhode {
namespace {

bool is_rgb(const AVPixFmtDescriptor& format) {
  return (format.flags & AV_PIX_FMT_FLAG_RGB) != 0;
}

Owned<AVFrame> empty_frame(int width, int height, AVPixelFormat format, bool rgb) {
  Owned<AVFrame> frame(made(av_frame_alloc()));
  frame->format = format;
  frame->width = width;
  frame->height = height;
  frame->sample_aspect_ratio = {1, 1};
  frame->color_range = rgb ? AVCOL_RANGE_JPEG : AVCOL_RANGE_MPEG;
  frame->colorspace = rgb ? AVCOL_SPC_RGB : AVCOL_SPC_BT709;
  frame->color_primaries = AVCOL_PRI_BT709;
  frame->color_trc = rgb ? AVCOL_TRC_IEC61966_2_1 : AVCOL_TRC_BT709;
  check_libav(av_frame_get_buffer(frame.get(), 0), "no memory for a frame");
  return frame;
}

}  // namespace

Converter::Converter(int width, int height, AVPixelFormat format) {
  const AVPixFmtDescriptor& kind = *av_pix_fmt_desc_get(format);
  frame_ = empty_frame(width, height, format, is_rgb(kind));
  scaler_.reset(made(sws_alloc_context()));
  std::vector<std::pair<const char*, int>> settings = {
      {"srcw", width},
      {"srch", height},
      {"src_format", AV_PIX_FMT_RGBA},
      {"dstw", width},
      {"dsth", height},
      {"dst_format", format},
      {"sws_flags", SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP},
  };
  // colour samples lie where players look for them, left of the middle; swscale would put them
  // half a pixel beside it
  if (kind.log2_chroma_w > 0 && !is_rgb(kind)) {
    settings.emplace_back("dst_h_chr_pos", 0);
    settings.emplace_back("dst_v_chr_pos", 128);
  }
  for (const auto& [key, value] : settings) {
    check_libav(av_opt_set_int(scaler_.get(), key, value, 0), key);
  }
  check_libav(sws_init_context(scaler_.get(), nullptr, nullptr),
              "swscale cannot convert this size");
  if (is_rgb(kind)) return;

  // full-range RGB in, limited-range BT.709 out; swscale's own default would be BT.601
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  constexpr int kOne = 1 << 16;
  check_libav(sws_setColorspaceDetails(scaler_.get(), bt709, 1, bt709, 0, 0, kOne, kOne),
              "swscale cannot convert to BT.709");
}

AVFrame* Converter::convert(const Image& image) {
  CHECK(image.width == frame_->width && image.height == frame_->height);
  check_libav(av_frame_make_writable(frame_.get()), "no memory for a frame");
  const std::uint8_t* rows[] = {image.pixels.data()};
  const int strides[] = {4 * image.width};
  check_libav(
      sws_scale(scaler_.get(), rows, strides, 0, image.height, frame_->data, frame_->linesize),
      "cannot convert a frame");
  return frame_.get();
}

}  // namespace polhode
