// SPDX-License-Identifier: MIT
// RAII types and error handling for FFmpeg's libraries. Private to video/, the only library that
// includes them.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/cpu.h>
#include <libavutil/imgutils.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <atomic>
#include <memory>
#include <string>

#include "base/error.h"

namespace polhode {

// Deleters for libav's objects. The file of a muxer belongs to FilmOutput and is not closed.
struct FreeLibav {
  void operator()(AVCodecContext* p) const { avcodec_free_context(&p); }
  void operator()(AVFormatContext* p) const { avformat_free_context(p); }
  void operator()(AVFrame* p) const { av_frame_free(&p); }
  void operator()(AVPacket* p) const { av_packet_free(&p); }
  void operator()(SwsContext* p) const { sws_freeContext(p); }
};
template <class T>
using Owned = std::unique_ptr<T, FreeLibav>;

// The deleter for a film that is opened for reading, which also closes its file.
struct CloseInput {
  void operator()(AVFormatContext* p) const { avformat_close_input(&p); }
};
using LibavInput = std::unique_ptr<AVFormatContext, CloseInput>;

// Opens a film. Only containers of films are known: libav would also read lists of other files,
// whatever their name (concat, HLS). Throws Error (input), without a place, if it is none of them,
// and film_error() if it cannot be read.
LibavInput open_film(const std::string& file);

// Options for a libav call. The call removes the entries that it understands.
class LibavOptions {
 public:
  LibavOptions() = default;
  ~LibavOptions() { av_dict_free(&entries_); }
  LibavOptions(const LibavOptions&) = delete;
  LibavOptions& operator=(const LibavOptions&) = delete;

  // Sets an option; both texts are copied.
  void set(const char* key, const std::string& value);
  // For the libav call; owned by this object.
  AVDictionary** pass() { return &entries_; }
  // Throws Error (environment), with `who` and the option in the message, if an entry is left.
  void refuse_leftovers(const std::string& who) const;

 private:
  AVDictionary* entries_ = nullptr;
};

// libav's message for an error code.
std::string libav_words(int code);

// An Error without a place for a film that libav cannot read. `what` says what is wrong with the
// film ("is damaged"), unless the code is that of a system call that failed for lack of memory or
// open files: then the fault is (environment).
Error film_error(int code, const std::string& what);

// Checks the result of a libav call that fails through no fault of the user, and returns it. `what`
// is what was attempted, for the message. Throws Error (environment) with libav's message,
// (interrupted) if a signal ended the call.
int check_libav(int code, const std::string& what);

// Sends a frame (null: end of the film) to an encoder, and calls use() whenever `packet` holds a
// new packet. `what` is as for check_libav. Throws what check_libav and `use` throw.
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

// Returns the result of an allocation by libav, which the caller must own. Throws Error
// (environment) if it is null.
template <class T>
T* made(T* object) {
  if (object == nullptr) throw environment_error("no memory for the film");
  return object;
}

// A frame whose pixels are yet to be written, with the room behind them that swscale needs. Throws
// Error (environment) if there is no memory.
Owned<AVFrame> new_frame(int width, int height, AVPixelFormat format);

// Sends libav's warnings and errors to the log, where --verbose shows them, and drops the rest. It
// holds for the whole process and may be called more than once.
void quieten_libav();

// Sets `told`, which must outlive the decoder, when the decoder tells the log of an error. Some
// decoders do, and then pass on a wrong picture, or none, without another word. For decoders that
// are not open yet, after quieten_libav().
void watch(AVCodecContext& decoder, std::atomic<bool>& told);

}  // namespace polhode
