// SPDX-License-Identifier: MIT
// Films through libavcodec, libavformat and libswscale.
#pragma once

#include "video/frame_sink.h"

namespace polhode {

// A film of the format that the ending of job.output says (video/encoders.h): BT.709 converted and
// tagged, exact constant frame rate, closed groups of at most a second, key frames where the
// metadata want them, index before the data, straight alpha. Throws Error (input) for odd sides
// where colour has half the resolution, (environment) when the encoder is missing or does not open,
// when the disk is full or the pipe closed.
std::unique_ptr<FrameSink> make_film_sink(const SinkJob& job);

// FFmpeg's own version text.
std::string libav_version();
// The libraries of it that were found at run time: "libavcodec 59.37.100, …".
std::string libav_parts();

}  // namespace polhode
