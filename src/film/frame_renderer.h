// SPDX-License-Identifier: MIT
// The interface of what renders the frames of a film, in this process or in worker processes.
#pragma once

#include "base/system/stage_clock.h"
#include "image/image.h"
#include "render/renderer.h"

namespace polhode {

// Time spent on drawing, summed over processes.
struct DrawingTimes {
  StageTime compose;  // making draw lists
  RenderTimes render;
};

// Renders frames of a film. A frame has the same pixels wherever it is rendered. Use it on one
// thread.
class FrameRenderer {
 public:
  virtual ~FrameRenderer() = default;
  // Renders frame `index` of the film into `image`, which is resized if needed. Throws Error
  // (environment) and (interrupted).
  virtual void render(int index, Image& image) = 0;
  // What draws.
  virtual const RendererInfo& info() const = 0;
  // Time spent so far.
  virtual DrawingTimes times() const = 0;
};

}  // namespace polhode
