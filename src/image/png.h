// SPDX-License-Identifier: MIT
// PNG files to and from Images (libpng's simplified interface).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "image/image.h"

namespace polhode {

class AtomicFile;

// A file that claims more pixels than this is refused: 16384 x 16384, a gigabyte in memory.
inline constexpr std::size_t kMostPngPixels = std::size_t{1} << 28;

// Writes 8-bit RGB, or RGBA when with_alpha; the file appears whole or not at all.
// Throws Error (input) for an unwritable place, (environment) when writing fails.
void write_png(const std::filesystem::path& path, const Image& image, bool with_alpha);

// The same into a file that the caller has claimed, and commits when it wants to.
void write_png(const AtomicFile& file, const Image& image, bool with_alpha);

// The bytes of such a file.
std::string encode_png(const Image& image, bool with_alpha);

// The picture in the bytes of a file; `name` stands for it in messages.
Image decode_png(const std::string& bytes, const std::string& name);

// Reads any PNG as 8-bit RGBA. Throws Error (input) when it is missing, no PNG, or too large.
Image read_png(const std::filesystem::path& path);

}  // namespace polhode
