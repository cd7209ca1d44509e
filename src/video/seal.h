// SPDX-License-Identifier: MIT
// A seal at the end of a film file: a text and a hash that detects any change of the file. It is
// stored in an element that players skip ("free" in MP4 and MOV, Void in Matroska).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

// Appends a seal with that text (less than 2^28 bytes) to a complete MP4, MOV or WebM file, whose
// first bytes say which container it is. Throws Error (environment), without a place, if writing
// fails, and as read_file() (base/system/atomic_file.h) does if it cannot be read.
void seal_file(const std::filesystem::path& file, std::string_view text);

// The text of the seal; absent if there is none or if the file has changed since. Throws as
// read_file() does if it cannot be read.
std::optional<std::string> sealed_text(const std::filesystem::path& file);

}  // namespace polhode
