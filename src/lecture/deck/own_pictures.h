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

// Reads a file with one of these endings. Throws Error (input), without a place, if a browser would
// show none of it or a part: if it is of another kind, cut off or found damaged, an SVG that is no
// XML, has another namespace or needs other files; and as read_input() (base/system/atomic_file.h)
// does.
void require_picture(const std::filesystem::path& file, const std::string& ending);

}  // namespace polhode
