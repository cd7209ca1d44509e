// SPDX-License-Identifier: MIT
// Renders the frames of a film in one or more processes.
#pragma once

#include <memory>
#include <vector>

#include "film/frame_renderer.h"
#include "film/prepared_film.h"

namespace polhode {

// Opens a renderer for frames with the numbers `frames`. Its render() must be called with exactly
// these numbers, in this order. `film` must outlive it; `setup` and `frames` are not kept.
//
// With setup.jobs = 1, the calling thread renders. With more, that many processes are forked (at
// most one per frame), because in llvmpipe the OpenGL contexts of one process block each other.
// Each renders every jobs-th of `frames` on one thread, into shared memory, at most three frames
// ahead. fork() copies only the calling thread, so this must be called before anything opens fonts
// or OpenGL. The processes end with the renderer or with this process. Pixels do not depend on the
// number of jobs.
//
// Throws Error with one job as open_local_renderer (film/local_renderer.h) does, with more
// (environment) if a process cannot be started. In that case info() and render() throw the Errors
// of the processes, those of open_local_renderer included, and Error (environment) if one was
// killed.
std::unique_ptr<FrameRenderer> open_frame_renderer(const PreparedFilm& film,
                                                   const RenderSetup& setup,
                                                   const std::vector<int>& frames);

}  // namespace polhode
