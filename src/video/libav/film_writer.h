// SPDX-License-Identifier: MIT
// Encoder, container and output of one film. Not for other libraries.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "video/encoders.h"
#include "video/frame_sink.h"
#include "video/libav/film_output.h"
#include "video/libav/libav.h"

namespace polhode {

// Takes frames in the encoder's own pixels and writes a film of constant rate, with closed groups
// of at most a second, tags, title and chapters. All throw Error with the name of the output.
class FilmWriter {
 public:
  // Opens the output and the encoder. Throws Error (input) for odd sides where colour has half the
  // resolution, as FilmOutput and find_encoder do, (environment) when the encoder does not open.
  explicit FilmWriter(const SinkJob& job);

  AVPixelFormat pixels() const { return encoder_->pix_fmt; }

  // Chapters; before the first frame.
  void describe(const FilmMetadata& metadata);
  // A frame with its pts, in 1 / rate or what the encoder took. A key frame begins a group.
  void write(AVFrame& frame, bool key);
  // An option that the muxer only needs at the end.
  void set_at_end(const char* option, std::int64_t value);
  // Text that the finished film is sealed with (video/seal.h).
  void seal_with(const std::string& text) { seal_ = text; }
  // The rest is encoded, the container closed, the film gets its name.
  void finish();

  // The threads that the encoder started; they live as long as this object.
  const std::set<int>& threads() const { return threads_; }

 private:
  void open_encoder();
  void write_header();
  void encode(const AVFrame* frame);

  SinkJob job_;
  const FilmFormat& format_;
  const FilmEncoder& row_;
  FilmOutput output_;
  Owned<AVFormatContext> muxer_;
  Owned<AVCodecContext> encoder_;
  Owned<AVPacket> packet_;
  AVStream* stream_ = nullptr;  // owned by the muxer
  std::set<int> threads_;
  bool begun_ = false;
  std::optional<std::string> seal_;
};

}  // namespace polhode
