// SPDX-License-Identifier: MIT
// Opens the destination of a plan: a whole output, a shard of it, or segments that are joined at
// the end.
#pragma once

#include <functional>
#include <memory>

#include "base/system/progress.h"
#include "film/frame_renderer.h"
#include "film/output/render_output.h"
#include "film/render_plan.h"
#include "video/pipeline.h"

namespace polhode {

// Opens the output, which claims its files before any work is done. `plan` must outlive it.
// `with_hashes`: keep frame_hash() (video/plain_sinks.h) of every frame, for
// RenderOutput::hashes(). Throws Error (input) and (environment) as make_sink (video/sink_kinds.h)
// and, with plan.resume, FilmJoiner (video/film_joiner.h) do.
std::unique_ptr<RenderOutput> open_output(const RenderPlan& plan, bool with_hashes);

// Renders all of output.frames() with `renderer`, on the calling thread, into output.sink(), on a
// second thread, and finishes the sink. Call it after output.begin(). `on_frame` (not empty) is
// called on the calling thread after each frame. Throws Error as `renderer` and the sink do, and
// (interrupted); each is passed through RenderOutput::explained().
void render_frames(RenderOutput& output,
                   FrameRenderer& renderer,
                   const std::function<void(const PipelineStep&)>& on_frame);

// The name of the stage that limits the speed at that step, for Progress::show(): "drawing",
// "encoding", or "writing" for outputs without an encoder.
std::string limiting_stage(const RenderPlan& plan, const PipelineStep& step);

// render_frames() for the output of that plan, with its progress on stderr.
void render_with_progress(const RenderPlan& plan,
                          RenderOutput& output,
                          FrameRenderer& renderer,
                          ProgressKind kind);

}  // namespace polhode
