// SPDX-License-Identifier: MIT
// The interface of the destinations of a plan's frames: whole output, shard, segments.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "film/output/shard.h"
#include "film/prepared_film.h"
#include "video/frame_sink.h"

namespace polhode {

// Receives the frames of a plan: all of them, those of a shard, or those that an earlier run has
// not made. Claims its files when it is constructed, before any work is done. Use it on one thread;
// only sink() may be pushed to on another thread meanwhile, as run_pipeline (video/pipeline.h)
// does. The derived classes are made by open_output() (film/output/open_output.h).
class RenderOutput {
 public:
  RenderOutput() = default;
  virtual ~RenderOutput() = default;
  RenderOutput(const RenderOutput&) = delete;
  RenderOutput& operator=(const RenderOutput&) = delete;

  // Called once, when the film is prepared and before the first frame; `film` is not kept. Throws
  // Error (input) with --shard as key if there are more shards than frames, and with --resume as
  // key for segments of another film or if their folder cannot be created; otherwise as
  // FrameSink::describe and comment_with (film/output/segments.h) do; (interrupted).
  virtual void begin(const PreparedFilm& film) = 0;

  // The numbers of the frames that must be pushed into the sink, in this order. They count from 0,
  // the first of FrameTimes. Call it after begin().
  const std::vector<int>& frames() const { return frames_; }
  // All frames of the finished output: those above and those of an earlier run. Call it after
  // begin().
  const FrameRange& range() const { return range_; }
  // How many frames of range() an earlier run has made. Call it after begin().
  int already_there() const { return range_.count - static_cast<int>(frames_.size()); }

  // Where to push the frames; valid as long as this object. Call it after begin().
  virtual FrameSink& sink() = 0;
  // Time spent in the sink by this run.
  virtual SinkTimes times() const = 0;
  // frame_hash() (video/plain_sinks.h) of each frame of range(), complete after sink().finish();
  // empty unless open_output() was asked for hashes (a resumed film always has them).
  virtual const std::vector<std::string>& hashes() const = 0;
  // The error with a note about what an aborted run leaves behind for the next one.
  virtual Error explained(const Error& error) const { return error; }

 protected:
  std::vector<int> frames_;
  FrameRange range_;
};

}  // namespace polhode
