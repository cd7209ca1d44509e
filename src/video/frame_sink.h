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

// One row per kind of output: how it is recognised and made.
struct SinkKind {
  std::string name;                                      // "mp4"
  std::string ending;                                    // ".mp4"; empty when recognised otherwise
  std::string doc;                                       // one phrase for `list formats`
  bool alpha = false;                                    // can keep transparency
  bool film = false;                                     // one file of many frames, for people
  bool (*accepts)(const std::string& output) = nullptr;  // null: by the ending
  std::unique_ptr<FrameSink> (*make)(const SinkJob&) = nullptr;
};

// All kinds, in the order in which they are tried.
const std::vector<SinkKind>& sink_kinds();

// The kind of that output. Throws Error (input) for an unknown ending (naming the nearest).
const SinkKind& find_sink_kind(const std::string& output);

// The file of captions beside a film of that name, NAME.vtt; empty where none is written.
std::string captions_beside(const std::string& output);

// The sink for job.output. Throws Error (input) for an unknown ending (naming the nearest), odd
// film sizes, a folder that cannot be written; (environment) for a missing encoder.
std::unique_ptr<FrameSink> make_sink(const SinkJob& job);

}  // namespace polhode
