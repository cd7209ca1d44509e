// SPDX-License-Identifier: MIT
// The [video] table of a scene, and the settings of encoders.
#pragma once

#include <string>
#include <vector>

#include "base/fields.h"
#include "image/picture_size.h"

namespace polhode {

// Frames per second as an exact ratio, such as 60/1 or 30000/1001.
struct FrameRate {
  int numerator = 60;
  int denominator = 1;

  double value() const { return static_cast<double>(numerator) / denominator; }
  friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

inline constexpr int kMostFramesPerSecond = 1000;

// Parses "60" or "30000/1001"; the result is in lowest terms. Throws Error (input), without a
// place, for other text (also "29.97") and for rates below 1 or above kMostFramesPerSecond.
FrameRate parse_frame_rate(const std::string& text);

// The limits of check_picture_size().
inline constexpr int kSmallestSide = 16;    // pixels
inline constexpr int kLargestSide = 16384;  // pixels; limit of OpenGL and of H.264 levels

// The most pixels of a picture: with four samples of colour and depth, more would exceed the size
// of one buffer.
inline constexpr int kMostPixels = 8192 * 8192;

// Throws Error (input), without a place, for a size outside these limits.
void check_picture_size(const PictureSize& size);

// Parses "1920x1080". Throws Error (input), without a place, for other text and as
// check_picture_size does.
PictureSize parse_picture_size(const std::string& text);

// The quality of a film, as --quality takes it; qualities() in film/render_plan.h lists the
// settings of each.
enum class Grade { draft, lecture, archive };

// How a film is encoded (FilmEncoder: video/encoders.h). The number of threads is fixed because
// x264's output depends on it.
struct EncoderSettings {
  std::string codec;                // FilmEncoder::codec, "h264"; empty: the default of the format
  std::string preset = "veryfast";  // effort, one of encoder_presets(); empty: the codec has none
  int crf = 18;         // constant rate factor, 1 (best) to FilmEncoder::worst_crf; 0: none
  bool finest = false;  // 4:4:4 colour where players support it, and the best profile
  int threads = 2;      // encoder threads, at least 1
};

// The values of --preset, fastest first: the presets of x264. Other encoders map them to their own
// settings. The list exists until the program ends.
const std::vector<std::string>& encoder_presets();

// The [video] table.
struct VideoSpec {
  PictureSize size;               // of the film, pixels
  FrameRate fps;                  // of the film
  double time_scale = 1.0;        // seconds of motion per second of film
  bool loop = false;              // end the film where the motion is back at its start
  double loop_residual = 0.0349;  // rad; allowed Loop::residual (motion/closed_loop.h)
  double shutter = 0.0;  // shutter angle, rad: 2 pi exposes from frame to frame; 0: an instant
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
          Doc{"end the film where the motion is back at its start, so that it can repeat without a "
              "jump"});
  v.field("loop_residual",
          s.loop_residual,
          Doc{"allowed difference of the attitude from the start where a loop closes",
              Unit::angle,
              kPositive});
  v.field(
      "shutter",
      s.shutter,
      Doc{"shutter angle, for motion blur: 360 degrees exposes from frame to frame, 0 an instant",
          Unit::angle,
          Range{0.0, 6.2831853071795872}});
}

}  // namespace polhode
