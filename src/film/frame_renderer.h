// SPDX-License-Identifier: MIT
// The interface of what renders the frames of a film, in this process or in worker processes.
#pragma once

#include "base/system/stage_clock.h"
#include "image/image.h"
#include "render/renderer.h"

namespace polhode {

// Time spent on drawing, summed over processes, so wall times may exceed that of the run.
struct DrawingTimes {
  StageTime compose;   // making draw lists
  RenderTimes render;  // turning them into pixels
};

// Renders frames of a film. A frame has the same pixels wherever it is rendered. Use and destroy it
// on the thread that has opened it: there its OpenGL context is current.
class FrameRenderer {
 public:
  virtual ~FrameRenderer() = default;
  // Renders the frame with the number `index`, 0 <= index < FrameTimes::count (film/frame_times.h),
  // into `image`, which is resized if needed. Throws Error as Film::at (frame/film.h) and
  // Renderer::draw do; with worker processes also (interrupted) and what a process has thrown, for
  // example when it opened its renderer (open_local_renderer() in film/local_renderer.h).
  virtual void render(int index, Image& image) = 0;
  // The same; the frame is whole after the Retouch, which another thread may call meanwhile.
  virtual Retouch begin(int index, Image& image) {
    render(index, image);
    return {};
  }
  // Back end and OpenGL that draw. Waits until a worker process has opened them, and then throws
  // Error as render() does. Valid as long as the renderer.
  virtual const RendererInfo& info() const = 0;
  // Time spent so far; with worker processes, up to the last frame that each has delivered.
  virtual DrawingTimes times() const = 0;
};

}  // namespace polhode
