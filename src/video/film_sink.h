// SPDX-License-Identifier: MIT
// H.264 films through libavcodec, libavformat and libswscale.
#pragma once

#include "video/frame_sink.h"

namespace polhode {

// An MP4 that players and presentation programs take: High profile, yuv420p, BT.709 converted and
// tagged, exact constant frame rate, closed groups of at most a second, index before the data.
// Throws Error (input) for odd sides, (environment) when libx264 is missing or the disk is full.
std::unique_ptr<FrameSink> make_film_sink(const SinkJob& job);

// Is an encoder of that name there?
bool has_encoder(const std::string& name);

// FFmpeg's own version text.
std::string libav_version();

}  // namespace polhode
