// SPDX-License-Identifier: MIT
// The interface of all sources of frames: a picture, a numbered sequence, a folder of
// pictures, a film.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "image/image.h"
#include "video/video_spec.h"

namespace polhode {

// Kinds of sources.
enum class SourceKind { picture, numbered, folder, film };

// A frame and what identifies it in its source.
struct SourceFrame {
  Image image;
  std::string label;  // number or file name in a sequence; "" for films and single pictures
  double time = 0.0;  // s after the first frame, for films; else 0
};

// What is known before all frames have been read.
struct SourceInfo {
  SourceKind kind = SourceKind::picture;
  std::vector<std::string> labels;  // of all frames; empty for films
  FrameRate fps;                    // for films; 60 if unknown
  int frames = 0;                   // for films approximate; 0: unknown
};

// Reads frames in order. Use it on one thread at a time.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  // The reference is valid as long as this object.
  virtual const SourceInfo& info() const = 0;
  // Gets the next frame; false at the end. May reuse the buffer of the image. Throws Error as
  // read_png (image/png.h) or FilmReader::next (video/film_reader.h) does: (input) for what is
  // missing or damaged, (environment) if FFmpeg cannot convert a frame.
  virtual bool next(SourceFrame& frame) = 0;
};

// Opens "a.png", "f_%05d.png" (all numbers that exist, in order, unless a file
// has that very name), a folder (its .png files, with
// numbers in their names sorted by value), or a film such as "a.mp4". Throws Error (input), with
// `name`, or the folder of a sequence, as place, for other names, for missing files and as
// FilmReader does; (environment) as FilmReader does.
std::unique_ptr<FrameSource> open_frames(const std::string& name);

}  // namespace polhode
