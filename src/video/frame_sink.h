// SPDX-License-Identifier: MIT
// Where frames go: a film, a picture, a numbered sequence, a list of hashes, or nowhere.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/stage_clock.h"
#include "image/image.h"
#include "video/video_spec.h"

namespace polhode {

// What a sink must know before the first frame.
struct SinkJob {
  std::string output;        // as the user gave it; "clip.mp4", "still.png", "f_%05d.png", "hash:F"
  int width = 0;             // pixels
  int height = 0;            // pixels
  FrameRate fps;             // exact
  EncoderSettings encoder;   // for films
  bool transparent = false;  // keep alpha; a sink that cannot refuses (Error, input)
  bool still = false;        // exactly one frame will come
  std::string title;         // container metadata
  std::string comment;       // container metadata
};

// Times of the sink's own stages.
struct SinkTimes {
  StageTime convert;  // RGBA to the encoder's pixel format
  StageTime encode;   // encoding, muxing, writing
};

// Takes frames in order. The output exists under its name only after finish(); a sink that is
// destroyed without finish() leaves nothing behind. All throw Error.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void push(const Image& frame) = 0;
  virtual void finish() = 0;
  virtual SinkTimes times() const = 0;
};

// One row per kind of output: how it is recognised and made.
struct SinkKind {
  std::string name;    // "mp4"
  std::string ending;  // ".mp4"; empty when recognised otherwise
  std::string doc;     // one phrase for `list formats`
  bool alpha = false;  // can keep transparency
  bool (*accepts)(const SinkJob&);
  std::unique_ptr<FrameSink> (*make)(const SinkJob&);
};

// All kinds, in the order in which they are tried.
const std::vector<SinkKind>& sink_kinds();

// The sink for job.output. Throws Error (input) for an unknown ending (naming the nearest), odd
// film sizes, a folder that cannot be written; (environment) for a missing encoder.
std::unique_ptr<FrameSink> make_sink(const SinkJob& job);

}  // namespace polhode
