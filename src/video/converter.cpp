// SPDX-License-Identifier: MIT
#include "video/converter.h"

#include <algorithm>
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

// for pictures of one size, as a whole
Owned<SwsContext> make_scaler(int width, int height, const AVPixFmtDescriptor& kind, int format) {
  Owned<SwsContext> scaler(made(sws_alloc_context()));
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
    check_libav(av_opt_set_int(scaler.get(), key, value, 0), key);
  }
  check_libav(sws_init_context(scaler.get(), nullptr, nullptr), "swscale cannot convert this size");
  if (is_rgb(kind)) return scaler;

  // full-range RGB in, limited-range BT.709 out; swscale's own default would be BT.601
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  constexpr int kOne = 1 << 16;
  check_libav(sws_setColorspaceDetails(scaler.get(), bt709, 1, bt709, 0, 0, kOne, kOne),
              "swscale cannot convert to BT.709");
  return scaler;
}

// A box with room for the filter of colour samples around it, on a grid, so that few sizes occur.
PixelBox on_grid(const PixelBox& box, int width, int height) {
  constexpr int kRoom = 8;
  constexpr int kGrid = 16;
  const auto down = [](int x) {
    return std::max(0, x - kRoom) / kGrid * kGrid;
  };
  const auto up = [](int x, int most) {
    return std::min(most, (x + kRoom + kGrid - 1) / kGrid * kGrid);
  };
  const int x = down(box.x);
  const int y = down(box.y);
  return {x, y, up(box.right(), width) - x, up(box.bottom(), height) - y};
}

}  // namespace

Converter::Converter(int width, int height, AVPixelFormat format) {
  frame_ = empty_frame(width, height, format, is_rgb(*av_pix_fmt_desc_get(format)));
  scaler_for(width, height);  // what cannot work is told now
}

SwsContext& Converter::scaler_for(int width, int height) {
  constexpr std::size_t kMost = 64;  // sizes of boxes change slowly
  if (scalers_.size() > kMost) scalers_.clear();
  Owned<SwsContext>& scaler = scalers_[{width, height}];
  if (scaler == nullptr) {
    const auto format = static_cast<AVPixelFormat>(frame_->format);
    scaler = make_scaler(width, height, *av_pix_fmt_desc_get(format), format);
  }
  return *scaler;
}

// What is painted now or was before; everything where the ground is not known or another one, and
// for RGB, of which swscale copies whole rows, whatever the width.
std::vector<PixelBox> Converter::to_convert(const Image& image) const {
  const bool rgb = is_rgb(*av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame_->format)));
  if (rgb || !image.ground || image.ground != ground_) {
    return {{0, 0, image.width, image.height}};
  }
  std::vector<PixelBox> boxes;
  for (const std::vector<PixelBox>* list : {&image.painted, &painted_}) {
    for (const PixelBox& box : *list)
      boxes.push_back(on_grid(box, image.width, image.height));
  }
  return merged(boxes);
}

void Converter::convert_box(const Image& image, const PixelBox& box) {
  const AVPixFmtDescriptor& kind = *av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame_->format));
  const std::uint8_t* rows[] = {image.at(box.x, box.y)};
  const int strides[] = {4 * image.width};
  // where the box begins in each plane
  std::uint8_t* planes[4] = {};
  for (int c = 0; c < kind.nb_components; ++c) {
    const AVComponentDescriptor& part = kind.comp[c];
    const bool color = (c == 1 || c == 2) && !is_rgb(kind);
    const std::ptrdiff_t x = color ? box.x >> kind.log2_chroma_w : box.x;
    const std::ptrdiff_t y = color ? box.y >> kind.log2_chroma_h : box.y;
    planes[part.plane] =
        frame_->data[part.plane] + y * frame_->linesize[part.plane] + x * part.step;
  }
  check_libav(sws_scale(&scaler_for(box.width, box.height),
                        rows,
                        strides,
                        0,
                        box.height,
                        planes,
                        frame_->linesize),
              "cannot convert a frame");
}

AVFrame* Converter::convert(const Image& image) {
  CHECK(image.width == frame_->width && image.height == frame_->height);
  check_libav(av_frame_make_writable(frame_.get()), "no memory for a frame");
  for (const PixelBox& box : to_convert(image))
    convert_box(image, box);
  ground_ = image.ground;
  painted_ = image.painted;
  return frame_.get();
}

}  // namespace polhode
