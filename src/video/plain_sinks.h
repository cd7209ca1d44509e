// SPDX-License-Identifier: MIT
// Sinks for machines: hashes of frames, and nothing at all.
#pragma once

#include <string_view>

#include "video/frame_sink.h"

namespace polhode {

// What stands before the file name when the ending is to be free: "hash:frames.txt".
inline constexpr std::string_view kHashPrefix = "hash:";

std::unique_ptr<FrameSink> make_hash_sink(const SinkJob& job);
std::unique_ptr<FrameSink> make_null_sink(const SinkJob& job);

}  // namespace polhode
