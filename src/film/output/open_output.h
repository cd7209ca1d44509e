// SPDX-License-Identifier: MIT
// The three destinations of a plan: one whole output, a shard of it, or segments that are joined.
#pragma once

#include <functional>
#include <memory>

#include "film/frame_renderer.h"
#include "film/output/render_output.h"
#include "film/render_plan.h"
#include "video/pipeline.h"

namespace polhode {

// `plan` must outlive it. with_hashes: keep the hash of every frame. Throws Error as make_sink
// does.
std::unique_ptr<RenderOutput> open_output(const RenderPlan& plan, bool with_hashes);

// Renders all frames that the output wants, and finishes it. `on_frame` as in run_pipeline.
void render_frames(RenderOutput& output,
                   FrameRenderer& renderer,
                   const std::function<void(const PipelineStep&)>& on_frame);

// The stage that the others wait for, for a progress bar.
std::string limiting_stage(const RenderPlan& plan, const PipelineStep& step);

}  // namespace polhode
