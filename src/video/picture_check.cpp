// SPDX-License-Identifier: MIT
#include "video/picture_check.h"

#include <cstring>

#include "video/libav/libav.h"

namespace polhode {

bool is_damaged(const std::string& bytes, CodedPicture kind) {
  quieten_libav();
  const bool is_jpeg = kind == CodedPicture::jpeg;
  const AVCodec* codec = avcodec_find_decoder(is_jpeg ? AV_CODEC_ID_MJPEG : AV_CODEC_ID_WEBP);
  if (codec == nullptr) return false;
  const Owned<AVCodecContext> decoder(made(avcodec_alloc_context3(codec)));
  check_libav(avcodec_open2(decoder.get(), codec, nullptr), "no decoder for a picture");
  const Owned<AVPacket> packet(made(av_packet_alloc()));
  check_libav(av_new_packet(packet.get(), static_cast<int>(bytes.size())),
              "no memory for a picture");
  std::memcpy(packet->data, bytes.data(), bytes.size());
  int code = avcodec_send_packet(decoder.get(), packet.get());
  if (code >= 0) code = avcodec_send_packet(decoder.get(), nullptr);
  const Owned<AVFrame> frame(made(av_frame_alloc()));
  if (code >= 0) code = avcodec_receive_frame(decoder.get(), frame.get());
  // at its end it has had nothing to decode
  return code == AVERROR_INVALIDDATA || code == AVERROR_EOF;
}

}  // namespace polhode
