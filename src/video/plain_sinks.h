// SPDX-License-Identifier: MIT
// Sinks for machines: hashes of frames, and nothing at all.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "video/frame_sink.h"

namespace polhode {

// What stands before the file name when the ending is to be free: "hash:frames.txt".
inline constexpr std::string_view kHashPrefix = "hash:";

// What stands for a frame in lists and reports: a hash of its pixels, straight RGBA.
std::string frame_hash(const Image& frame);

// The same sink; the hash of each frame is added to the list, which must outlive it.
std::unique_ptr<FrameSink> with_hashes(std::unique_ptr<FrameSink> sink,
                                       std::vector<std::string>& hashes);

std::unique_ptr<FrameSink> make_hash_sink(const SinkJob& job);
std::unique_ptr<FrameSink> make_null_sink(const SinkJob& job);

}  // namespace polhode
