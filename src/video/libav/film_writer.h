// SPDX-License-Identifier: MIT
// Encodes and muxes one film. Private to video/.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "video/encoders.h"
#include "video/frame_sink.h"
#include "video/libav/film_output.h"
#include "video/libav/libav.h"

namespace polhode {

// Takes frames in the encoder's pixel format and writes a film of constant rate, with closed groups
// of pictures of at most a second, tags, title and chapters. Not thread-safe. write() and finish()
// throw Error (environment) and (interrupted), with the output as place, and finish() also as
// seal_file does; describe() and set_at_end() throw Error (environment) as check_libav
// (video/libav/libav.h) does.
class FilmWriter {
 public:
  // Opens the output and the encoder; job.output must be a film (find_film_format()). Throws Error
  // as FilmOutput and find_encoder (video/encoders.h) do, (input), with the output as place, if a
  // side is odd and the format has subsampled colour, (environment) if the encoder does not open.
  explicit FilmWriter(const SinkJob& job);

  // The encoder's pixel format.
  AVPixelFormat pixels() const { return encoder_->pix_fmt; }

  // Sets chapters and comment, if the container keeps them. To be called before the first frame.
  void describe(const FilmMetadata& metadata);
  // Encodes a frame, whose pts is set in the encoder's time base (a frame, or 0.01 s for GIF).
  // `key` makes it a key frame.
  void write(AVFrame& frame, bool key);
  // Sets an option that the muxer reads when it writes the trailer.
  void set_at_end(const char* option, std::int64_t value);
  // Sets the text of the seal (video/seal.h), without which the film is not sealed.
  void seal_with(const std::string& text) { seal_ = text; }
  // Flushes the encoder, closes the container and gives the film its name. At least one frame must
  // have been written.
  void finish();

  // The ids (Linux tid) of the encoder's threads. The threads live, and the reference is valid, as
  // long as this object.
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
