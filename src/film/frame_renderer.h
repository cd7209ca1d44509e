// SPDX-License-Identifier: MIT
// What renders the frames of a film, in this process or in others.
#pragma once

#include "base/system/stage_clock.h"
#include "image/image.h"
#include "render/renderer.h"

namespace polhode {

// Time spent on drawing; of several processes, the sum.
struct DrawingTimes {
  StageTime compose;
  RenderTimes render;
};

// Renders frames of a film; the same index gives the same pixels, wherever it is drawn.
class FrameRenderer {
 public:
  virtual ~FrameRenderer() = default;
  // `image` gets the right size; its buffer is used again. Throws Error.
  virtual void render(int index, Image& image) = 0;
  virtual const RendererInfo& info() const = 0;
  virtual DrawingTimes times() const = 0;
};

}  // namespace polhode
