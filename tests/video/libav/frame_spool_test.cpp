// SPDX-License-Identifier: MIT
#include "video/libav/frame_spool.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

constexpr int kWidth = 37, kHeight = 21;

// noise that no lossy codec would keep
Owned<AVFrame> noise(unsigned seed) {
  std::mt19937 random(seed);
  Owned<AVFrame> frame(made(av_frame_alloc()));
  frame->format = AV_PIX_FMT_BGRA;
  frame->width = kWidth;
  frame->height = kHeight;
  frame->pts = seed;
  check_libav(av_frame_get_buffer(frame.get(), 0), "frame");
  for (int y = 0; y < kHeight; ++y) {
    std::generate_n(frame->data[0] + y * frame->linesize[0], 4 * kWidth, [&] {
      return static_cast<std::uint8_t>(random());
    });
  }
  return frame;
}

std::vector<std::uint8_t> bgra_of(const AVFrame& frame) {
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* row = frame.data[0] + y * frame.linesize[0];
    bytes.insert(bytes.end(), row, row + 4 * frame.width);
  }
  return bytes;
}

TEST(FrameSpool, GivesFramesBackInOrderBitByBit) {
  const test::TemporaryFolder folder;
  FrameSpool spool(folder.path(), kWidth, kHeight, AV_PIX_FMT_BGRA, 2);
  for (unsigned i = 0; i < 9; ++i)
    spool.push(*noise(i));
  EXPECT_EQ(folder.entries(), 0) << "the file has no name";
  spool.rewind();
  for (unsigned i = 0; i < 9; ++i) {
    const AVFrame* frame = spool.take();
    ASSERT_NE(frame, nullptr) << i;
    EXPECT_EQ(bgra_of(*frame), bgra_of(*noise(i))) << i;
  }
  EXPECT_EQ(spool.take(), nullptr);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(FrameSpool, AFolderThatIsNotThereIsAnError) {
  test::expect_error([] { FrameSpool("/nowhere", kWidth, kHeight, AV_PIX_FMT_BGRA, 1); },
                     Fault::environment,
                     "",
                     "cannot keep frames");
}

}  // namespace
}  // namespace polhode
