// SPDX-License-Identifier: MIT
#include "video/picture_check.h"

#include <cstdint>
#include <cstring>

#include "video/libav/libav.h"

namespace polhode {
namespace {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;

// The first picture in some bytes, and the last answer of libav: below zero if there is none.
struct Decoded {
  Owned<AVFrame> frame;
  int code;
};

Decoded decoded(const std::string& bytes, const AVCodec* codec) {
  const Owned<AVCodecContext> decoder(made(avcodec_alloc_context3(codec)));
  decoder->max_pixels = kMostPixels;
  check_libav(avcodec_open2(decoder.get(), codec, nullptr), "no decoder for a picture");
  const Owned<AVPacket> packet(made(av_packet_alloc()));
  check_libav(av_new_packet(packet.get(), static_cast<int>(bytes.size())),
              "no memory for a picture");
  std::memcpy(packet->data, bytes.data(), bytes.size());
  int code = avcodec_send_packet(decoder.get(), packet.get());
  if (code >= 0) code = avcodec_send_packet(decoder.get(), nullptr);
  Owned<AVFrame> frame(made(av_frame_alloc()));
  if (code >= 0) code = avcodec_receive_frame(decoder.get(), frame.get());
  return {std::move(frame), code};
}

const AVCodec* decoder_of(CodedPicture kind) {
  return avcodec_find_decoder(kind == CodedPicture::jpeg ? AV_CODEC_ID_MJPEG : AV_CODEC_ID_WEBP);
}

}  // namespace

bool is_damaged(const std::string& bytes, CodedPicture kind) {
  quieten_libav();
  const AVCodec* codec = decoder_of(kind);
  if (codec == nullptr) return false;
  const int code = decoded(bytes, codec).code;
  // at its end it has had nothing to decode
  return code == AVERROR_INVALIDDATA || code == AVERROR_EOF;
}

bool is_turned(const std::string& jpeg) {
  quieten_libav();
  const AVCodec* codec = decoder_of(CodedPicture::jpeg);
  if (codec == nullptr) return false;
  const Decoded picture = decoded(jpeg, codec);
  return picture.code >= 0 &&
         av_frame_get_side_data(picture.frame.get(), AV_FRAME_DATA_DISPLAYMATRIX) != nullptr;
}

}  // namespace polhode
