// SPDX-License-Identifier: MIT
// Tables of the films that can be written: containers by their ending, codecs, and libav's encoders
// with what is asked of each. A new format is a row here.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "video/video_spec.h"

struct AVCodecContext;

namespace polhode {

class LibavOptions;

// One way to compress a film: a codec by one of libav's encoders.
struct FilmEncoder {
  std::string codec;            // as --codec takes it, "h264"
  std::string title;            // for people, "H.264"
  std::string name;             // libav's, "libx264"
  std::string doc;              // one phrase: what for
  bool alpha = false;           // can keep transparency
  bool presets = false;         // takes --preset
  int worst_crf = 0;            // --crf is 1 (best) to this; 0: it takes none
  std::array<int, 3> crf = {};  // for draft, lecture, archive
  // AVPixelFormat of frames with alpha or without, at the finest or as players like it
  int (*pixels)(bool alpha, bool finest) = nullptr;
  // everything else it is told before it opens; size, rate and tags are there already
  void (*configure)(const EncoderSettings&, AVCodecContext&, LibavOptions&) = nullptr;
};

// All of them; of several with the same codec the first that this FFmpeg has is taken.
const std::vector<FilmEncoder>& film_encoders();

// A container, recognised by the ending of the output.
struct FilmFormat {
  std::string ending;                               // ".mp4"
  std::string muxer;                                // libav's name
  std::vector<std::string> codecs;                  // the first is the default
  bool keeps_metadata = false;                      // keeps title, chapters; captions go beside
  std::vector<std::array<std::string, 2>> options;  // of the muxer
};
const std::vector<FilmFormat>& film_formats();

// The format of that output, by its ending, "-" as .y4m; null when it is no film.
const FilmFormat* find_film_format(const std::string& output);

// Is an encoder of that name in this FFmpeg?
bool has_encoder(const std::string& name);

// The row for a codec of this format; "" is its default. Throws Error (input) for a codec that the
// format does not take, (environment) when this FFmpeg has no encoder for it, with what to install.
const FilmEncoder& find_encoder(const FilmFormat& format, const std::string& codec);

// What the user asked of the encoder; absent: what the grade says.
struct EncoderWish {
  Grade grade = Grade::lecture;
  std::string preset = "veryfast";    // the grade's own
  std::optional<std::string> codec;   // --codec
  std::optional<std::string> forced;  // --preset
  std::optional<int> crf;             // --crf
};

// What that means for this output. Throws Error (input), with the option, for a codec, a preset or
// a quality that the format does not take.
EncoderSettings settle_encoder(const std::string& output, const EncoderWish& wish);

}  // namespace polhode
