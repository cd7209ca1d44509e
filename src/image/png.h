// SPDX-License-Identifier: MIT
// Reads and writes PNG files (with libpng's simplified interface).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "image/image.h"

namespace polhode {

class AtomicFile;

// Files with more pixels than this (16384 x 16384, a gigabyte in memory) are refused.
inline constexpr std::size_t kMostPngPixels = std::size_t{1} << 28;

// Writes a picture of at least one pixel as 8-bit RGBA if with_alpha, else as RGB, without its
// alpha. The file appears complete or not at all. Throws Error (input) as AtomicFile
// (base/system/atomic_file.h) does, (environment), with the file as place, if writing fails.
void write_png(const std::filesystem::path& path, const Image& image, bool with_alpha);

// Writes to the temporary file of `file`, which the caller will commit. Throws Error (environment),
// with the target as place, if writing fails.
void write_png(const AtomicFile& file, const Image& image, bool with_alpha);

// The bytes of such a PNG file. Throws Error (environment), without a place, if encoding fails.
std::string encode_png(const Image& image, bool with_alpha);

// Decodes the bytes of any PNG file to 8-bit RGBA. `name` is the file name for messages. Throws
// Error (input), with `name` as place, if it is not a PNG, is damaged or has more than
// kMostPngPixels.
Image decode_png(const std::string& bytes, const std::string& name);

// Whether the bytes of a PNG file, or those before its pixels, are of an animation.
bool is_animation(const std::string& bytes);

// Reads any PNG file as 8-bit RGBA. Throws Error (input) as read_file (base/system/atomic_file.h)
// and decode_png do, and for an animation.
Image read_png(const std::filesystem::path& path);

// All that a PNG file says beside its pixels and, of an animation, their times: size, kind, and how
// to show them. Throws Error as read_file() does.
std::string png_tags(const std::filesystem::path& path);

}  // namespace polhode
