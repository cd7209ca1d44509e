// SPDX-License-Identifier: MIT
// Reads the frames of a film file in order.
#pragma once

#include <memory>
#include <string>

#include "image/image.h"
#include "video/video_spec.h"

namespace polhode {

// What the file says about its first video track.
struct FilmInfo {
  int width = 0;        // pixels
  int height = 0;       // pixels
  int frames = 0;       // 0: unknown
  FrameRate fps;        // average rate; 60 if unknown
  double length = 0.0;  // s, as the container says; 0: unknown
  bool alpha = false;   // whether it has transparency
  std::string codec;    // FFmpeg's name of the decoder, "h264"
  // What it asks of players: shape of the pixels, and range, primaries, transfer and matrix of the
  // colours; "1:1 tv bt709 bt709 bt709". Then where else than at the left of their blocks the
  // colours are, and whether it is interlaced. If the container tells others, these too.
  std::string shown;
};

// Decodes frames in display order, with one decoder thread per processor. Frames are converted to
// 8-bit sRGB with the matrix and range that each is tagged with. Untagged ones count as BT.709
// from 720 rows on and as BT.601 below, as in players. Subsampled colour is not interpolated: each
// sample is used for all pixels that it covers. Not thread-safe.
class FilmReader {
 public:
  // Throws Error, with the file as place: (input) if it is missing, not a regular file, not a film,
  // has a damaged header or more than 2^28 pixels per frame, (environment) if FFmpeg has no decoder
  // for it, or none for its transparency, or no memory.
  explicit FilmReader(const std::string& file);
  ~FilmReader();
  FilmReader(const FilmReader&) = delete;
  FilmReader& operator=(const FilmReader&) = delete;

  // The reference is valid as long as this object.
  const FilmInfo& info() const;

  // Gets the next frame, with straight alpha, and its time (s after the first frame); false at
  // the end. Reuses the buffer of `frame`, which then has no ground. Throws Error, with the file as
  // place: (input) if the file is damaged or truncated or if the picture size changes,
  // (environment) if FFmpeg cannot convert the frame.
  bool next(Image& frame, double& time);
  // What the frame that was read last asks of players, as FilmInfo::shown: shape of the pixels,
  // range, primaries, transfer and matrix of the colours, and where these are.
  std::string frame_shown() const;
  // When the last frame that was read ends, s after the first begins, as the file says.
  double end() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// Whether the name has the ending of a film, in lower case: .mp4, .mkv, .mov, .webm, .gif, .avi,
// .m4v or .apng.
bool has_film_ending(const std::string& name);

}  // namespace polhode
