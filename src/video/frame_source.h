// SPDX-License-Identifier: MIT
// Where frames come from: a picture, a numbered sequence, a folder of pictures, a film.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "image/image.h"
#include "video/video_spec.h"

namespace polhode {

enum class SourceKind { picture, numbered, folder, film };

struct SourceFrame {
  Image image;
  std::string label;  // number or file name in a sequence; "" in a film and of a single picture
  double time = 0.0;  // s after the first frame of a film; 0 elsewhere
};

// What is known before all has been read.
struct SourceInfo {
  SourceKind kind = SourceKind::picture;
  std::vector<std::string> labels;  // of all frames, except in a film
  FrameRate fps;                    // of a film
  int frames = 0;                   // about how many there will be; 0: not known
};

// Gives frames in order.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual const SourceInfo& info() const = 0;
  // False at the end. The image's buffer is used again. Throws Error (input) for what cannot be
  // read.
  virtual bool next(SourceFrame& frame) = 0;
};

// "a.png", "f_%05d.png" (every number there is, in order), a folder (its .png files, numbers in
// their names in order of size), "a.mp4" or another film. Throws Error (input) for anything else
// and for what is not there.
std::unique_ptr<FrameSource> open_frames(const std::string& name);

}  // namespace polhode
