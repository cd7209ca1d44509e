// SPDX-License-Identifier: MIT
// The interface of all destinations of frames: films, pictures, numbered sequences, lists of
// hashes, nothing.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/system/stage_clock.h"
#include "image/image.h"
#include "video/video_spec.h"

namespace polhode {

// The output name that stands for standard output.
inline constexpr const char* kStandardOutput = "-";

// What a sink must know when it is opened.
struct SinkJob {
  std::string output;  // as the user gave it: "clip.mp4", "still.png", "f_%05d.png", "hash:F"
  int width = 0;       // pixels
  int height = 0;      // pixels
  FrameRate fps;       // exact; of a GIF at most 50 frames/s
  std::optional<FrameRate> asked_fps = {};  // what was asked for, if it is another; to be told
  EncoderSettings encoder;                  // for films
  bool transparent = false;  // keep alpha; make_sink() refuses it for kinds without alpha
  bool still = false;        // exactly one frame will be pushed
  std::string title;         // for containers that keep metadata; empty: none
  std::string comment;       // for containers that keep metadata; empty: none
  bool segment = false;      // part of a film: sealed (video/seal.h) and without caption file
  bool captions = false;     // the film may get captions, so that their file is claimed at once
};

// What is known about a film once its motion is computed. Frames count from 0.
struct FilmMetadata {
  struct Chapter {
    int start = 0;  // frame
    std::string title;
  };
  struct Caption {
    int start = 0;  // first frame that shows it
    int end = 0;    // first frame that does not show it any more
    std::string words;
  };
  int frames = 0;               // number of frames that will be pushed
  std::vector<int> key_frames;  // frames, besides 0, at which players must be able to seek exactly
  std::vector<Chapter> chapters;  // by start, the first at 0; may be empty
  std::vector<Caption> captions;  // by start; written to NAME.vtt
  std::string comment = {};       // for the container; empty: SinkJob::comment
  int first = 0;  // number of the first frame in names of picture files and in lists of hashes
};

// Time spent in the stages of the sink.
struct SinkTimes {
  StageTime convert;  // RGBA to the encoder's pixel format
  StageTime encode;   // encoding, muxing, writing; also hashing
};

// Takes frames in order. Use it on one thread at a time; run_pipeline() pushes on a thread of its
// own. The output gets its name in finish(); a sink that is destroyed without finish() leaves
// nothing behind. push() and finish() throw Error (environment) if writing fails, and
// (interrupted); push() also throws Error (input) as AtomicFile (base/system/atomic_file.h) does if
// it opens a file per frame or segment.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  // Called at most once, before the first frame. Sinks that cannot use it ignore it. Throws Error
  // as with_captions() (video/captions.h) says, and (environment) without memory.
  virtual void describe(const FilmMetadata&) {}
  // Takes the next frame, of the size of the job.
  virtual void push(const Image& frame) = 0;
  // Completes the output. Called once, after the last frame.
  virtual void finish() = 0;
  // The time spent so far.
  virtual SinkTimes times() const = 0;
};

}  // namespace polhode
