// SPDX-License-Identifier: MIT
// The [video] table of a scene, and how films are encoded.
#pragma once

#include <string>
#include <vector>

#include "base/fields.h"
#include "image/picture_size.h"

namespace polhode {

// Frames per second as an exact ratio, e.g. 60/1 or 30000/1001.
struct FrameRate {
  int numerator = 60;
  int denominator = 1;

  double value() const { return static_cast<double>(numerator) / denominator; }
  friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

// "60", "29.97" is refused in favour of "30000/1001". Throws Error (input).
FrameRate parse_frame_rate(const std::string& text);

inline constexpr int kSmallestSide = 16;    // pixels
inline constexpr int kLargestSide = 16384;  // pixels; what GL and H.264 level limits leave

// The largest picture: with four samples of colour and depth it takes what one buffer may hold.
inline constexpr int kMostPixels = 8192 * 8192;

// Throws Error (input) for a size out of bounds.
void check_picture_size(const PictureSize& size);

// "1920x1080". Throws Error (input) when it is not of that form or out of bounds.
PictureSize parse_picture_size(const std::string& text);

// How good a film is to be.
enum class Grade { draft, lecture, archive };

// How a film is encoded. Threads are pinned because x264's output depends on their number.
struct EncoderSettings {
  std::string codec;                // "h264", …; empty: the first that the format takes
  std::string preset = "veryfast";  // effort, one of encoder_presets(); empty: there is none
  int crf = 18;                     // constant rate factor, 1 is best; 0: the codec has none
  bool finest = false;              // 4:4:4 where players take it, and the best profile
  int threads = 2;                  // encoder threads
};

// The efforts that may be asked for, fastest first: the presets of x264, which other encoders
// follow in their own terms.
const std::vector<std::string>& encoder_presets();

// The [video] table.
struct VideoSpec {
  PictureSize size;
  FrameRate fps;
  double time_scale = 1.0;        // seconds of motion per second of film
  bool loop = false;              // the film ends where it began
  double loop_residual = 0.0349;  // rad: how exactly
  double shutter = 0.0;           // part of a turn of the shutter that is open, rad; 0: an instant
};

template <class Visitor>
void fields(Visitor& v, VideoSpec& s) {
  v.field("size", s.size, Doc{"picture size, \"1920x1080\" or [1920, 1080]"});
  v.field("fps", s.fps, Doc{"frames per second: a whole number or an exact ratio \"30000/1001\""});
  v.field("time_scale",
          s.time_scale,
          Doc{"seconds of motion per second of film; 0.1 is ten times slow motion",
              Unit::none,
              kPositive});
  v.field("loop",
          s.loop,
          Doc{"end the film where the motion is as it was at its start, so that it repeats"});
  v.field("loop_residual",
          s.loop_residual,
          Doc{"how far the attitude may be off where a loop closes", Unit::angle, kPositive});
  v.field("shutter",
          s.shutter,
          Doc{"angle of the open shutter: 360 degrees blur all that happens from frame to frame",
              Unit::angle,
              Range{0.0, 6.2831853071795872}});
}

}  // namespace polhode
