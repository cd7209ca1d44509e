// SPDX-License-Identifier: MIT
// Writes animated GIFs with a palette made for the film.
#pragma once

#include "video/frame_sink.h"

namespace polhode {

// A sink for a GIF that repeats forever, of at most 50 frames/s (see gif_rate()). Times are rounded
// to 0.01 s, and alpha to clear or solid. A warning in the log always tells these limits. One
// palette of 256 colours for the whole film is made by libavfilter from the moving parts in
// finish(), which needs at least one frame. Until then the frames are kept in a lossless unnamed
// file in the folder of the output, so memory does not grow with the film. Throws Error as
// make_film_sink (video/film_sink.h) does, and (environment) if libavfilter is missing or the
// frames cannot be kept.
std::unique_ptr<FrameSink> make_gif_sink(const SinkJob& job);

// The rate of a GIF of a film of that rate: a whole part of it, the largest of at most 50 frames/s.
FrameRate gif_rate(const FrameRate& fps);

}  // namespace polhode
