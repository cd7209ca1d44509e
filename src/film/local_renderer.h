// SPDX-License-Identifier: MIT
// Renders frames in this process, on the calling thread.
#pragma once

#include <memory>

#include "film/frame_renderer.h"
#include "film/prepared_film.h"

namespace polhode {

// Opens a renderer for any frames in any order, with an OpenGL context that is current on the
// calling thread: use and destroy the renderer on that thread. `film` must outlive it; `setup` is
// not kept, and its `jobs` is not used. Throws Error (input) and (environment) as open_context
// (render/context.h) and Renderer (render/renderer.h) do.
std::unique_ptr<FrameRenderer> open_local_renderer(const PreparedFilm& film,
                                                   const RenderSetup& setup);

}  // namespace polhode
