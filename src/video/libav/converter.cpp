// SPDX-License-Identifier: MIT
#include "video/libav/converter.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/check.h"

namespace polhode {
namespace {

bool is_rgb(const AVPixFmtDescriptor& format) {
  return (format.flags & AV_PIX_FMT_FLAG_RGB) != 0;
}

Owned<AVFrame> empty_frame(int width, int height, AVPixelFormat format, bool rgb) {
  Owned<AVFrame> frame = new_frame(width, height, format);
  frame->sample_aspect_ratio = {1, 1};
  frame->color_range = rgb ? AVCOL_RANGE_JPEG : AVCOL_RANGE_MPEG;
  frame->colorspace = rgb ? AVCOL_SPC_RGB : AVCOL_SPC_BT709;
  frame->color_primaries = AVCOL_PRI_BT709;
  frame->color_trc = rgb ? AVCOL_TRC_IEC61966_2_1 : AVCOL_TRC_BT709;
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

// Colour samples are means over neighbouring pixels: a change shows in those beside it.
constexpr int kReach = 2;  // rows; even, for colour may have half of them
constexpr int kRows = 64;  // of a piece that is converted at once
constexpr int kGrid = 32;  // columns, so that few sizes occur

// A box with all that its pixels have a part in.
PixelBox with_reach(const PixelBox& box, int width, int height) {
  constexpr int kRoom = 8;  // columns
  const int x = std::max(0, box.x - kRoom) / kGrid * kGrid;
  const int y = std::max(0, box.y - kReach) / 2 * 2;
  const int right = std::min(width, (box.right() + kRoom + kGrid - 1) / kGrid * kGrid);
  const int bottom = std::min(height, (box.bottom() + kReach + 1) / 2 * 2);
  return {x, y, right - x, bottom - y};
}

// where the box begins in each plane
std::array<std::uint8_t*, 4> planes_at(AVFrame& frame, int x, int y) {
  const auto format = static_cast<AVPixelFormat>(frame.format);
  const AVPixFmtDescriptor& kind = *av_pix_fmt_desc_get(format);
  std::array<std::uint8_t*, 4> planes = {};
  for (int c = 0; c < kind.nb_components; ++c) {
    const AVComponentDescriptor& part = kind.comp[c];
    const bool color = (c == 1 || c == 2) && !is_rgb(kind);
    const std::ptrdiff_t column = color ? x >> kind.log2_chroma_w : x;
    const std::ptrdiff_t row = color ? y >> kind.log2_chroma_h : y;
    planes[static_cast<std::size_t>(part.plane)] =
        frame.data[part.plane] + row * frame.linesize[part.plane] + column * part.step;
  }
  return planes;
}

}  // namespace

Converter::Converter(int width, int height, AVPixelFormat format) {
  const bool rgb = is_rgb(*av_pix_fmt_desc_get(format));
  frame_ = empty_frame(width, height, format, rgb);
  part_ = empty_frame(width, kRows + 2 * kReach, format, rgb);
  scaler_for(width, height);  // what cannot work is told now
}

SwsContext& Converter::scaler_for(int width, int height) {
  constexpr std::size_t kMost = 256;  // sizes of boxes change slowly
  if (scalers_.size() > kMost) scalers_.clear();
  Owned<SwsContext>& scaler = scalers_[{width, height}];
  if (scaler == nullptr) {
    const auto format = static_cast<AVPixelFormat>(frame_->format);
    scaler = make_scaler(width, height, *av_pix_fmt_desc_get(format), format);
  }
  return *scaler;
}

// What is painted now or was before.
std::vector<PixelBox> Converter::to_convert(const Image& image) const {
  std::vector<PixelBox> boxes;
  for (const std::vector<PixelBox>* list : {&image.painted, &painted_}) {
    for (const PixelBox& box : *list)
      boxes.push_back(with_reach(box, image.width, image.height));
  }
  return in_bands(boxes, kRows);
}

// to the corner of a frame
void Converter::convert_box(const Image& image, const PixelBox& box, AVFrame& frame) {
  const std::uint8_t* rows[] = {image.at(box.x, box.y)};
  const int strides[] = {4 * image.width};
  SwsContext& scaler = scaler_for(box.width, box.height);
  check_libav(sws_scale(&scaler, rows, strides, 0, box.height, frame.data, frame.linesize),
              "cannot convert a frame");
}

// with its surroundings, for swscale repeats the outermost pixels of what it is given
void Converter::convert_part(const Image& image, const PixelBox& box) {
  const int above = std::min(kReach, box.y);
  const int below = std::min(kReach, image.height - box.bottom());
  convert_box(image, {box.x, box.y - above, box.width, above + box.height + below}, *part_);
  std::array<std::uint8_t*, 4> to = planes_at(*frame_, box.x, box.y);
  const std::array<std::uint8_t*, 4> from = planes_at(*part_, 0, above);
  av_image_copy(to.data(),
                frame_->linesize,
                const_cast<const std::uint8_t**>(from.data()),
                part_->linesize,
                static_cast<AVPixelFormat>(frame_->format),
                box.width,
                box.height);
}

AVFrame* Converter::convert(const Image& image) {
  CHECK(image.width == frame_->width && image.height == frame_->height);
  check_libav(av_frame_make_writable(frame_.get()), "no memory for a frame");
  // of RGB swscale copies whole rows, whatever the width
  const bool rgb = is_rgb(*av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame_->format)));
  if (rgb || !image.ground || image.ground != ground_) {
    convert_box(image, {0, 0, image.width, image.height}, *frame_);
  } else {
    for (const PixelBox& box : to_convert(image))
      convert_part(image, box);
  }
  ground_ = image.ground;
  painted_ = image.painted;
  return frame_.get();
}

}  // namespace polhode
