// SPDX-License-Identifier: MIT
// Pictures that a deck brings along, as files.
#pragma once

#include <filesystem>
#include <string>

namespace polhode {

// The ending of a file in small letters, ".jpg" of "IMG_1.JPG".
std::string picture_ending(const std::string& file);
// Those that they may have.
bool is_picture_ending(const std::string& ending);

bool is_jpeg(const std::string& file);
// Whether slides.pptx and slides.tex have a description in place of this file.
bool is_for_pages_only(const std::string& file);

// Reads a file with one of these endings. Throws Error (input), without a place, if a browser would
// show none of it or a part: if it is of another kind, cut off or found damaged, an SVG that is no
// XML, has another namespace or needs other files; and as read_input() (base/system/atomic_file.h)
// does.
void require_picture(const std::filesystem::path& file, const std::string& ending);

// A JPEG as pandoc knows its size, by its first segment: with one that names it a JFIF file (ITU-T
// T.871), if it begins with neither that nor Exif. Those of red, green and blue stay as they are,
// for a JFIF file has other colours.
std::string as_jfif(std::string jpeg);

}  // namespace polhode
