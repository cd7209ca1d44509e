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

// Claims its files when it is constructed, before any work is done. Use it on one thread.
class RenderOutput {
 public:
  RenderOutput() = default;
  virtual ~RenderOutput() = default;
  RenderOutput(const RenderOutput&) = delete;
  RenderOutput& operator=(const RenderOutput&) = delete;

  // Called once, when the film is prepared and before the first frame. Throws Error (input) naming
  // --shard for an empty shard, and --resume for segments of another film.
  virtual void begin(const PreparedFilm& film) = 0;

  // The frames that must be pushed into the sink, in this order. Valid after begin().
  const std::vector<int>& frames() const { return frames_; }
  // All frames of the finished output. Valid after begin().
  const FrameRange& range() const { return range_; }
  // How many of them an earlier run has made.
  int already_there() const { return range_.count - static_cast<int>(frames_.size()); }

  // Where to push the frames. Valid after begin().
  virtual FrameSink& sink() = 0;
  // Time spent in the sink.
  virtual SinkTimes times() const = 0;
  // The hashes of all frames of the output, after sink().finish(); empty unless requested.
  virtual const std::vector<std::string>& hashes() const = 0;
  // The error with a note about what an aborted run leaves behind for the next one.
  virtual Error explained(const Error& error) const { return error; }

 protected:
  std::vector<int> frames_;
  FrameRange range_;
};

}  // namespace polhode
