// SPDX-License-Identifier: MIT
#include "video/libav/libav.h"

#include <cerrno>

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace polhode {
namespace {

TEST(Libav, ErrorsAreToldInItsWords) {
  EXPECT_EQ(check_libav(7, "what"), 7);
  EXPECT_EQ(libav_words(AVERROR(ENOENT)), "No such file or directory");
  test::expect_error([] { check_libav(AVERROR(ENOSPC), "cannot write the film"); },
                     Fault::environment,
                     "",
                     "cannot write the film: No space left on device");
  test::expect_error([] { made(static_cast<int*>(nullptr)); }, Fault::environment, "", "no memory");
}

// a grey frame of that height, as FFV1 takes it
Owned<AVFrame> grey_frame(std::int64_t pts) {
  Owned<AVFrame> frame(made(av_frame_alloc()));
  frame->format = AV_PIX_FMT_GRAY8;
  frame->width = frame->height = 16;
  frame->pts = pts;
  check_libav(av_frame_get_buffer(frame.get(), 0), "frame");
  for (int y = 0; y < 16; ++y)
    std::fill_n(frame->data[0] + y * frame->linesize[0], 16, std::uint8_t{90});
  return frame;
}

Owned<AVCodecContext> open_ffv1(LibavOptions& options) {
  const AVCodec* codec = avcodec_find_encoder(AV_CODEC_ID_FFV1);
  Owned<AVCodecContext> context(made(avcodec_alloc_context3(codec)));
  context->width = context->height = 16;
  context->pix_fmt = AV_PIX_FMT_GRAY8;
  context->time_base = {1, 25};
  check_libav(avcodec_open2(context.get(), codec, options.pass()), "open");
  return context;
}

// an option that nobody understood is an error, not a wish that is lost
TEST(Libav, OptionsThatAreLeftOverAreRefused) {
  LibavOptions understood;
  understood.set("coder", "1");
  open_ffv1(understood);
  EXPECT_NO_THROW(understood.refuse_leftovers("ffv1"));
  LibavOptions unknown;
  unknown.set("nonsense", "1");
  open_ffv1(unknown);
  test::expect_error([&] { unknown.refuse_leftovers("ffv1"); },
                     Fault::environment,
                     "",
                     "ffv1 does not know the option 'nonsense'");
}

// every packet comes out once, those that the encoder holds back too
TEST(Libav, EncodingGivesEveryPacket) {
  LibavOptions options;
  const Owned<AVCodecContext> encoder = open_ffv1(options);
  const Owned<AVPacket> packet(made(av_packet_alloc()));
  std::vector<std::int64_t> times;
  const auto keep = [&] {
    times.push_back(packet->pts);
    av_packet_unref(packet.get());
  };
  for (const std::int64_t pts : {0, 1, 2, 3})
    encode_frame(*encoder, grey_frame(pts).get(), *packet, "encode", keep);
  encode_frame(*encoder, nullptr, *packet, "encode", keep);
  EXPECT_EQ(times, (std::vector<std::int64_t>{0, 1, 2, 3}));
  test::expect_error([&] { encode_frame(*encoder, grey_frame(4).get(), *packet, "late", keep); },
                     Fault::environment,
                     "",
                     "late");
}

}  // namespace
}  // namespace polhode
