// SPDX-License-Identifier: MIT
// The tables of film formats: containers by their file ending, and codecs with libav's
// encoders and their options. To add a format: a row in film_formats(), and in film_encoders()
// for a new encoder.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "video/video_spec.h"

struct AVCodecContext;

namespace polhode {

class LibavOptions;

// A codec as implemented by one of libav's encoders.
struct FilmEncoder {
  std::string codec;            // as --codec takes it, "h264"
  std::string title;            // for display, "H.264"
  std::string name;             // libav's name, "libx264"
  std::string doc;              // one phrase: its purpose
  bool alpha = false;           // supports transparency
  bool presets = false;         // accepts --preset
  int worst_crf = 0;            // --crf is 1 (best) to this value; 0: it accepts none
  std::array<int, 3> crf = {};  // defaults for Grade draft, lecture, archive
  // The AVPixelFormat of its frames, with or without alpha, in the finest or the most
  // compatible form.
  int (*pixels)(bool alpha, bool finest) = nullptr;
  // Sets the options of the encoder before it opens; size, rate and colour tags are already set.
  void (*configure)(const EncoderSettings&, AVCodecContext&, LibavOptions&) = nullptr;
};

// All encoders. Of several with the same codec, the first that the installed FFmpeg has is used.
// This table and film_formats() exist until the program ends, and so do the rows that the functions
// below return.
const std::vector<FilmEncoder>& film_encoders();

// A container format, recognised by the ending of the output.
struct FilmFormat {
  std::string ending;               // ".mp4"
  std::string muxer;                // libav's name of the container
  std::vector<std::string> codecs;  // allowed codecs, the default first
  bool keeps_metadata = false;      // stores title, comment and chapters; captions go into NAME.vtt
  std::vector<std::array<std::string, 2>> options;  // options of the muxer: name, value
};
// All film formats.
const std::vector<FilmFormat>& film_formats();

// The format of an output by its ending ("-" is .y4m); null if it is not a film, and for names that
// begin with "hash:".
const FilmFormat* find_film_format(const std::string& output);

// Whether the installed FFmpeg has an encoder of that (libav's) name.
bool has_encoder(const std::string& name);

// The Debian package of the codec library that this program is linked with: "libavcodec61".
std::string codec_package();

// The encoder for a codec of this format; "" is the default codec. Throws Error (input), naming
// --codec, for a codec that the format does not allow; (environment), with what to install, if the
// installed FFmpeg has no encoder for it.
const FilmEncoder& find_encoder(const FilmFormat& format, const std::string& codec);

// The user's encoder options; absent ones are decided by the grade and the format.
struct EncoderWish {
  Grade grade = Grade::lecture;
  std::string preset = "veryfast";    // of the chosen --quality; not used if `forced` is given
  std::optional<std::string> codec;   // --codec
  std::optional<std::string> forced;  // --preset
  std::optional<int> crf;             // --crf
};

// The settings for this output; codec and preset are empty and crf is 0 where there are none.
// Throws Error (input), naming --codec, --preset or --crf, for a value that the format does not
// accept; (environment) as find_encoder does. An output that is neither a film nor a .png (hashes,
// null) accepts all options of a film, but --preset must still be one of encoder_presets().
EncoderSettings settle_encoder(const std::string& output, const EncoderWish& wish);

}  // namespace polhode
