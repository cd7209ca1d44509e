// SPDX-License-Identifier: MIT
// Draws the frames of a film.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "film/prepared_film.h"
#include "image/image.h"
#include "render/renderer.h"

namespace polhode {

// Time spent on drawing; of several processes, the sum.
struct DrawingTimes {
  StageTime compose;
  RenderTimes render;
};

// Makes any frame of a film; the same index gives the same pixels, whoever makes it.
class FrameRenderer {
 public:
  virtual ~FrameRenderer() = default;
  // `image` gets the right size; its buffer is used again. Throws Error.
  virtual void make(int index, Image& image) = 0;
  virtual const RendererInfo& info() const = 0;
  virtual DrawingTimes times() const = 0;
};

// Draws on the calling thread. `film` must outlive it. Throws Error as open_context and Renderer
// do.
std::unique_ptr<FrameRenderer> make_frame_renderer(const FilmFrames& film,
                                                   const std::string& backend,
                                                   bool transparent);

}  // namespace polhode
