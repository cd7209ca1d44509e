// SPDX-License-Identifier: MIT
// What libav finds in pictures of other programs.
#pragma once

#include <string>

namespace polhode {

// Kinds of pictures that libav decodes from their bytes, if they have no more than 2^28 pixels, as
// a WebP has at most; in larger ones nothing is found.
enum class CodedPicture { jpeg, webp };

// Whether libav finds these bytes damaged: it makes no picture of them, and not because it does not
// know their kind. It does not tell of all damage. Throws Error (environment) without memory.
bool is_damaged(const std::string& bytes, CodedPicture kind);

// Whether the camera says in a JPEG (by Exif) that its picture is to be turned or mirrored; false
// if libav makes none of it. Throws Error (environment) without memory.
bool is_turned(const std::string& jpeg);

}  // namespace polhode
