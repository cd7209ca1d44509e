// SPDX-License-Identifier: MIT
// Where frames go: a film, a picture, a numbered sequence, a list of hashes, or nowhere.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/system/stage_clock.h"
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
  bool segment = false;      // of a film: no captions beside it, and sealed (video/seal.h)
};

// What is known of a film when its motion has been found. Frames count from 0.
struct FilmMetadata {
  struct Chapter {
    int start = 0;  // frame
    std::string title;
  };
  struct Caption {
    int start = 0;  // first frame that has it
    int end = 0;    // first frame that has it no more
    std::string words;
  };
  int frames = 0;                 // how many will come
  std::vector<int> key_frames;    // where a player must be able to stop and begin, beside 0
  std::vector<Chapter> chapters;  // by start, the first at 0; none: empty
  std::vector<Caption> captions;  // by start; written beside films as NAME.vtt
  std::string comment = {};       // for the container; empty: the job's
  int first = 0;                  // number of the first in names and lists
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
  // Called at most once, before the first frame; sinks that cannot use it do nothing.
  virtual void describe(const FilmMetadata&) {}
  virtual void push(const Image& frame) = 0;
  virtual void finish() = 0;
  // Of the frames that are pushed the output has every n-th, from the first one on.
  virtual int keeps_every() const { return 1; }
  virtual SinkTimes times() const = 0;
};

}  // namespace polhode
