// SPDX-License-Identifier: MIT
// Sinks that write hashes of frames, or nothing.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "video/frame_sink.h"

namespace polhode {

// The prefix that selects a list of hashes for any file name: "hash:frames.txt".
inline constexpr std::string_view kHashPrefix = "hash:";

// The hash (content_hash in base/hash.h) of the pixels of a frame, RGBA with straight alpha, for
// lists and reports. Width and height are not part of it.
std::string frame_hash(const Image& frame);

// Wraps a sink (not null) so that the frame_hash() of each pushed frame is appended to `hashes`,
// which must outlive it.
std::unique_ptr<FrameSink> with_hashes(std::unique_ptr<FrameSink> sink,
                                       std::vector<std::string>& hashes);

// A sink that writes a text file with one line per frame: number, size and hash, as in "12
// 1920x1080 HASH". The numbers begin with FilmMetadata::first. Throws Error as AtomicFile
// (base/system/atomic_file.h) does, and (input), with the output as place, for "hash:" without a
// file name.
std::unique_ptr<FrameSink> make_hash_sink(const SinkJob& job);
// A sink that discards all frames, for benchmarks. `job` is not used.
std::unique_ptr<FrameSink> make_null_sink(const SinkJob& job);

}  // namespace polhode
