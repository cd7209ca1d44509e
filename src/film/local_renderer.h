// SPDX-License-Identifier: MIT
// Renders frames in this process, on the calling thread.
#pragma once

#include <memory>

#include "film/frame_renderer.h"
#include "film/prepared_film.h"

namespace polhode {

// Opens a renderer for any frames in any order. `film` must outlive it. Throws Error as
// open_context and Renderer do.
std::unique_ptr<FrameRenderer> open_local_renderer(const PreparedFilm& film,
                                                   const RenderSetup& setup);

}  // namespace polhode
