// SPDX-License-Identifier: MIT
// Several processes that draw the frames of one film.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "film/frame_renderer.h"

namespace polhode {

// Forks order.jobs processes (contexts of one process wait for each other in llvmpipe), each of
// which draws every jobs-th of `frames` with one thread, into memory that is shared, at most three
// frames ahead. make() must be called for `frames` in their order. The processes end with the
// maker, and with this process, however that ends. Each sets its own text: Pango's threads would
// not come along. Pixels are those of make_frame_renderer. Throws Error (environment) for a process
// that cannot be started, and from make() for one that was killed; what fails in a process is
// thrown by make() too.
std::unique_ptr<FrameRenderer> start_frame_workers(const RenderPlan& plan,
                                                   const PreparedFilm& basis,
                                                   const std::vector<int>& frames);

}  // namespace polhode
