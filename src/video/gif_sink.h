// SPDX-License-Identifier: MIT
// GIF films with a palette made for them.
#pragma once

#include "video/frame_sink.h"

namespace polhode {

// A GIF that repeats for ever, of at most 50 frames/s (every n-th frame of a faster film, at its
// exact time to a hundredth of a second), with one palette for the whole film, made by libavfilter
// of what moves. The log tells what was changed. Frames wait, losslessly compressed, in a file
// without a name in the folder of the output, so memory does not grow with the film and nothing
// stays behind. Throws Error as make_film_sink does.
std::unique_ptr<FrameSink> make_gif_sink(const SinkJob& job);

// How many frames of a film of that rate there are to one of its GIF.
int gif_step(const FrameRate& fps);

}  // namespace polhode
