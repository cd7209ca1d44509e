// SPDX-License-Identifier: MIT
#include "video/libav/filter_graph.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace polhode {
namespace {

constexpr int kSide = 16;  // pixels

// a ramp: each pixel is its column, and `base`
Owned<AVFrame> ramp(std::int64_t pts, int base = 0) {
  Owned<AVFrame> frame(made(av_frame_alloc()));
  frame->format = AV_PIX_FMT_GRAY8;
  frame->width = frame->height = kSide;
  frame->pts = pts;
  check_libav(av_frame_get_buffer(frame.get(), 0), "frame");
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x)
      frame->data[0][y * frame->linesize[0] + x] = static_cast<std::uint8_t>(base + x);
  }
  return frame;
}

TEST(FilterGraph, FramesComeOutFilteredWithTheirTimes) {
  FilterGraph mirror("[in]hflip[out]", {{"in", kSide, kSide, AV_PIX_FMT_GRAY8}});
  EXPECT_EQ(mirror.pull(), nullptr) << "nothing has gone in";
  for (const std::int64_t pts : {0, 4, 7}) {
    const Owned<AVFrame> in = ramp(pts);
    mirror.push(0, in.get());
    EXPECT_EQ(in->data[0][0], 0) << "the frame stays the caller's";
    const AVFrame* out = mirror.pull();
    ASSERT_NE(out, nullptr);
    EXPECT_EQ(out->pts, pts);
    for (int x = 0; x < kSide; ++x)
      EXPECT_EQ(out->data[0][3 * out->linesize[0] + x], kSide - 1 - x);
  }
  mirror.push(0, nullptr);
  EXPECT_EQ(mirror.pull(), nullptr);
}

TEST(FilterGraph, InputsAreToldApartByTheirNames) {
  FilterGraph beside(
      "[right][left]hstack[out]",
      {{"left", kSide, kSide, AV_PIX_FMT_GRAY8}, {"right", kSide, kSide, AV_PIX_FMT_GRAY8}});
  beside.push(0, ramp(0, 0).get());
  beside.push(1, ramp(0, 100).get());
  const AVFrame* out = beside.pull();
  ASSERT_NE(out, nullptr);
  ASSERT_EQ(out->width, 2 * kSide);
  EXPECT_EQ(out->data[0][0], 100);
  EXPECT_EQ(out->data[0][kSide], 0);
}

TEST(FilterGraph, AnUnknownFilterIsAnError) {
  quieten_libav();
  test::expect_error(
      [] {
        FilterGraph("[in]nonsense[out]", {{"in", kSide, kSide, AV_PIX_FMT_GRAY8}});
      },
      Fault::environment,
      "",
      "libavfilter");
}

}  // namespace
}  // namespace polhode
