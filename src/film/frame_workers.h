// SPDX-License-Identifier: MIT
// Renders the frames of one film in as many processes as are asked for.
#pragma once

#include <memory>
#include <vector>

#include "film/frame_renderer.h"
#include "film/prepared_film.h"

namespace polhode {

// A renderer whose render() is called with `frames`, in their order. `film` must outlive it.
//
// One job: the calling thread draws. More: so many processes are forked here (OpenGL contexts of
// one process wait for each other in llvmpipe), and each draws every jobs-th of `frames` with one
// thread, into shared memory, at most three frames ahead. fork() copies only the calling thread, so
// this comes before anything opens fonts or OpenGL. The processes end with the renderer, and with
// this process, however that ends. Pixels do not depend on the number of jobs.
//
// Throws Error as open_local_renderer does; (environment) for a process that cannot be started, and
// from render() for one that was killed. What fails in a process is thrown by render() here.
std::unique_ptr<FrameRenderer> open_frame_renderer(const PreparedFilm& film,
                                                   const RenderSetup& setup,
                                                   const std::vector<int>& frames);

}  // namespace polhode
