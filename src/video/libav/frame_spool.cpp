// SPDX-License-Identifier: MIT
#include "video/libav/frame_spool.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <unistd.h>

namespace polhode {
namespace {

Error no_room() {
  return environment_error("cannot keep frames for the palette: {}", std::strerror(errno));
}

// a file that only this process sees
int open_nameless(const std::filesystem::path& folder) {
  int file = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0) return file;
  // not every file system can; the name is gone a moment later
  std::string name = (folder / ".polhode-XXXXXX").string();
  file = mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) throw no_room();
  unlink(name.c_str());
  return file;
}

Owned<AVCodecContext> open_codec(const AVCodec* codec, const AVCodecContext& like) {
  if (codec == nullptr) throw environment_error("this FFmpeg lacks FFV1");
  Owned<AVCodecContext> context(made(avcodec_alloc_context3(codec)));
  context->width = like.width;
  context->height = like.height;
  context->pix_fmt = like.pix_fmt;
  context->time_base = {1, 1};
  context->thread_count = like.thread_count;
  context->thread_type = FF_THREAD_SLICE;
  context->level = 3;
  if (like.extradata_size > 0) {
    const auto size = static_cast<std::size_t>(like.extradata_size);
    context->extradata =
        static_cast<std::uint8_t*>(made(av_mallocz(size + AV_INPUT_BUFFER_PADDING_SIZE)));
    context->extradata_size = like.extradata_size;
    std::memcpy(context->extradata, like.extradata, size);
  }
  check_libav(avcodec_open2(context.get(), codec, nullptr), "FFV1 does not open");
  return context;
}

}  // namespace

FrameSpool::FrameSpool(
    const std::filesystem::path& folder, int width, int height, AVPixelFormat format, int threads)
    : packet_(made(av_packet_alloc())), frame_(made(av_frame_alloc())) {
  const int number = open_nameless(folder);
  file_.reset(fdopen(number, "w+b"));
  if (file_ == nullptr) {
    close(number);
    throw no_room();
  }
  const Owned<AVCodecContext> like(made(avcodec_alloc_context3(nullptr)));
  like->width = width;
  like->height = height;
  like->pix_fmt = format;
  like->thread_count = threads;
  encoder_ = open_codec(avcodec_find_encoder(AV_CODEC_ID_FFV1), *like);
}

void FrameSpool::push(const AVFrame& frame) {
  encode(&frame);
}

// each packet behind its size
void FrameSpool::encode(const AVFrame* frame) {
  encode_frame(*encoder_, frame, *packet_, "cannot keep a frame", [&] {
    const std::int32_t size = packet_->size;
    const bool written =
        std::fwrite(&size, sizeof size, 1, file_.get()) == 1 &&
        std::fwrite(packet_->data, 1, static_cast<std::size_t>(size), file_.get()) ==
            static_cast<std::size_t>(size);
    av_packet_unref(packet_.get());
    if (!written) throw no_room();
  });
}

void FrameSpool::rewind() {
  encode(nullptr);
  if (std::fflush(file_.get()) != 0 || std::fseek(file_.get(), 0, SEEK_SET) != 0) throw no_room();
  decoder_ = open_codec(avcodec_find_decoder(AV_CODEC_ID_FFV1), *encoder_);
  encoder_.reset();
}

bool FrameSpool::read_packet() {
  std::int32_t size = 0;
  if (std::fread(&size, sizeof size, 1, file_.get()) != 1) return false;
  check_libav(av_new_packet(packet_.get(), size), "no memory for a frame");
  if (std::fread(packet_->data, 1, static_cast<std::size_t>(size), file_.get()) !=
      static_cast<std::size_t>(size)) {
    throw no_room();
  }
  return true;
}

AVFrame* FrameSpool::take() {
  while (true) {
    const int code = avcodec_receive_frame(decoder_.get(), frame_.get());
    if (code == AVERROR_EOF) return nullptr;
    if (code != AVERROR(EAGAIN)) {
      check_libav(code, "cannot read a frame again");
      return frame_.get();
    }
    const bool more = read_packet();
    check_libav(avcodec_send_packet(decoder_.get(), more ? packet_.get() : nullptr),
                "cannot read a frame again");
    av_packet_unref(packet_.get());
  }
}

}  // namespace polhode
