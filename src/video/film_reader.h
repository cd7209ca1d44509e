// SPDX-License-Identifier: MIT
// The frames of a film file, one after another.
#pragma once

#include <memory>
#include <string>

#include "image/image.h"
#include "video/video_spec.h"

namespace polhode {

// What the file says of its first film track.
struct FilmInfo {
  int width = 0;       // pixels
  int height = 0;      // pixels
  int frames = 0;      // 0: the file does not say
  FrameRate fps;       // average
  bool alpha = false;  // has the film transparency?
  std::string codec;   // FFmpeg's name, "h264"
};

// Decodes in the order of display, on the calling thread and one of its own per processor.
// Frames come out as 8-bit sRGB through the matrix and range that the film is tagged with; an
// untagged film is taken for BT.709 from 720 rows on and BT.601 below, as players do. Colour that
// is stored at half the resolution is not interpolated: each sample serves the pixels it covers.
class FilmReader {
 public:
  // Throws Error (input) when the file is missing, no film, or larger than 2^28 pixels a frame;
  // (environment) when this FFmpeg has no decoder for it.
  explicit FilmReader(const std::string& file);
  ~FilmReader();
  FilmReader(const FilmReader&) = delete;
  FilmReader& operator=(const FilmReader&) = delete;

  const FilmInfo& info() const;

  // The next frame and when it is shown, s after the first frame; false at the end. The buffer is
  // used again. Throws Error (input) when the file is damaged or ends before its time.
  bool next(Image& frame, double& time);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// Does the name end as films do (.mp4, .mkv, .mov, .webm, .gif, .avi, .m4v, .apng)?
bool has_film_ending(const std::string& name);

}  // namespace polhode
