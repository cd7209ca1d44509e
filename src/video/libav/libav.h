// SPDX-License-Identifier: MIT
// The only includer of FFmpeg's libraries: objects that free themselves, options that must be
// understood, calls that must succeed. Not for other libraries.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/imgutils.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <memory>
#include <string>

#include "base/error.h"

namespace polhode {

// Frees what libav made; the file of a muxer belongs to FilmOutput.
struct FreeLibav {
  void operator()(AVCodecContext* p) const { avcodec_free_context(&p); }
  void operator()(AVFormatContext* p) const { avformat_free_context(p); }
  void operator()(AVFrame* p) const { av_frame_free(&p); }
  void operator()(AVPacket* p) const { av_packet_free(&p); }
  void operator()(SwsContext* p) const { sws_freeContext(p); }
};
template <class T>
using Owned = std::unique_ptr<T, FreeLibav>;

// A film that is read, with its file.
struct CloseInput {
  void operator()(AVFormatContext* p) const { avformat_close_input(&p); }
};
using LibavInput = std::unique_ptr<AVFormatContext, CloseInput>;

// Options for a libav call; entries that are left over were not understood.
class LibavOptions {
 public:
  LibavOptions() = default;
  ~LibavOptions() { av_dict_free(&entries_); }
  LibavOptions(const LibavOptions&) = delete;
  LibavOptions& operator=(const LibavOptions&) = delete;

  void set(const char* key, const std::string& value);
  AVDictionary** pass() { return &entries_; }
  // Throws Error (environment) when an entry is left.
  void refuse_leftovers(const std::string& who) const;

 private:
  AVDictionary* entries_ = nullptr;
};

// libav's own text for an error code.
std::string libav_words(int code);

// Every libav call that can fail through no fault of the user goes through here. Throws Error
// (environment) with libav's words, (interrupted) when a signal ended the call.
int check_libav(int code, const std::string& what);

// Hands a frame (null: no more) to an encoder, and every packet that comes out to `use`. Throws as
// check_libav does.
template <class Use>
void encode_frame(AVCodecContext& encoder,
                  const AVFrame* frame,
                  AVPacket& packet,
                  const std::string& what,
                  const Use& use) {
  check_libav(avcodec_send_frame(&encoder, frame), what);
  while (true) {
    const int code = avcodec_receive_packet(&encoder, &packet);
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    check_libav(code, what);
    use();
  }
}

// libav's way to say that there was no memory. Throws Error (environment).
template <class T>
T* made(T* object) {
  if (object == nullptr) throw environment_error("no memory for the film");
  return object;
}

// Sends libav's warnings and errors to the log (told with -v); its chatter goes nowhere.
void quieten_libav();

}  // namespace polhode
