// SPDX-License-Identifier: MIT
// Opens the destination of a plan: a whole output, a shard of it, or segments that are joined at
// the end.
#pragma once

#include <functional>
#include <memory>

#include "film/frame_renderer.h"
#include "film/output/render_output.h"
#include "film/render_plan.h"
#include "video/pipeline.h"

namespace polhode {

// `plan` must outlive the output. with_hashes: keep the hash of every frame. Throws Error as
// make_sink does.
std::unique_ptr<RenderOutput> open_output(const RenderPlan& plan, bool with_hashes);

// Renders all of output.frames() into its sink and finishes it. on_frame and errors as in
// run_pipeline.
void render_frames(RenderOutput& output,
                   FrameRenderer& renderer,
                   const std::function<void(const PipelineStep&)>& on_frame);

// The name of the slowest stage at the moment, for the progress bar.
std::string limiting_stage(const RenderPlan& plan, const PipelineStep& step);

}  // namespace polhode
