// SPDX-License-Identifier: MIT
// A seal at the end of a film file: text, and a hash by which any change of the file is seen. It
// stands in an element that players skip ("free" of MP4 and MOV, Void of Matroska).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

// Appends it; the name's ending (before .part) tells the container. Throws Error (environment) when
// the disk is full.
void seal_file(const std::filesystem::path& file, std::string_view text);

// The text of the seal; nothing where there is none, or where the file is not as it was sealed.
// Throws Error (input) when the file cannot be read.
std::optional<std::string> sealed_text(const std::filesystem::path& file);

}  // namespace polhode
