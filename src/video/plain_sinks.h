// SPDX-License-Identifier: MIT
// Sinks for machines: hashes of frames, and nothing at all.
#pragma once

#include "video/frame_sink.h"

namespace polhode {

std::unique_ptr<FrameSink> make_hash_sink(const SinkJob& job);
std::unique_ptr<FrameSink> make_null_sink(const SinkJob& job);

}  // namespace polhode
