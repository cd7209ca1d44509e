// SPDX-License-Identifier: MIT
// Where the frames of a plan go.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "film/output/shard.h"
#include "film/prepared_film.h"
#include "video/frame_sink.h"

namespace polhode {

// Claims its files when it is made, before any work is done.
class RenderOutput {
 public:
  RenderOutput() = default;
  virtual ~RenderOutput() = default;
  RenderOutput(const RenderOutput&) = delete;
  RenderOutput& operator=(const RenderOutput&) = delete;

  // Once, when the film is known and before the first frame. Throws Error (input) for a shard of
  // nothing, and for segments of another film.
  virtual void begin(const PreparedFilm& film) = 0;

  // Which frames of the film are to be pushed into the sink, in this order; after begin().
  const std::vector<int>& frames() const { return frames_; }
  // All frames that the output has when it is done; after begin().
  const FrameRange& range() const { return range_; }
  // How many of them were there already.
  int already_there() const { return range_.count - static_cast<int>(frames_.size()); }

  virtual FrameSink& sink() = 0;
  virtual SinkTimes times() const = 0;
  // Of all frames of the output, when the sink has finished; empty unless they were asked for.
  virtual const std::vector<std::string>& hashes() const = 0;
  // The error, with what an early end leaves behind for the next run.
  virtual Error explained(const Error& error) const { return error; }

 protected:
  std::vector<int> frames_;
  FrameRange range_;
};

}  // namespace polhode
