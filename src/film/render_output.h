// SPDX-License-Identifier: MIT
// Where the frames of an order go: one output, one piece of it, or pieces that become one.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "film/frame_renderer.h"
#include "film/resumed_film.h"
#include "video/pipeline.h"

namespace polhode {

// Claims the output before any work is done.
class RenderOutput {
 public:
  // Throws Error as make_sink does. `order` must outlive it.
  RenderOutput(const RenderPlan& plan, bool with_hashes);
  RenderOutput(const RenderOutput&) = delete;
  RenderOutput& operator=(const RenderOutput&) = delete;

  // Now that the frames are known. Throws Error (input) for a shard of nothing, and for pieces of
  // another film.
  void begin(const PreparedFilm& film);

  // Which frames of the film are to be pushed, in this order.
  const std::vector<int>& frames() const { return frames_; }
  // How many more were there already.
  int there() const { return there_; }
  const FrameRange& range() const { return range_; }  // of all that the output has
  FrameSink& sink() { return *sink_; }
  // Of all frames of the output, if asked for; when the sink has finished.
  const std::vector<std::string>& hashes() const { return resumed_ ? resumed_->hashes() : hashes_; }

  // The stage that limits, for a progress bar.
  std::string limit(const PipelineStep& step) const;
  // The error with what is kept, when something is.
  Error explained(const Error& error) const;

 private:
  const RenderPlan& plan_;
  std::unique_ptr<FrameSink> sink_;
  ResumedFilm* resumed_ = nullptr;  // sink_, if it is one
  std::vector<int> frames_;
  FrameRange range_;
  int there_ = 0;
  std::vector<std::string> hashes_;
};

// Makes all frames that the target wants and finishes it. `on_frame` as in run_pipeline.
void fill_output(RenderOutput& target,
                 FrameRenderer& renderer,
                 const std::function<void(const PipelineStep&)>& on_frame);

}  // namespace polhode
