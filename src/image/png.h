// SPDX-License-Identifier: MIT
// PNG files to and from Images (libpng's simplified interface).
#pragma once

#include <filesystem>

#include "image/image.h"

namespace polhode {

// Writes 8-bit RGB, or RGBA when with_alpha; the file appears whole or not at all.
// Throws Error (input) for an unwritable place, (environment) when writing fails.
void write_png(const std::filesystem::path& path, const Image& image, bool with_alpha);

// Reads any PNG as 8-bit RGBA. Throws Error (input) when it is missing or no PNG.
Image read_png(const std::filesystem::path& path);

}  // namespace polhode
