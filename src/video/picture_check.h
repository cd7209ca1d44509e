// SPDX-License-Identifier: MIT
// Whether pictures of other programs can be decoded.
#pragma once

#include <string>

namespace polhode {

// Kinds of pictures that libav decodes from their bytes.
enum class CodedPicture { jpeg, webp };

// Whether libav finds these bytes damaged: it makes no picture of them, and not because it does not
// know their kind. It does not tell of all damage. Throws Error (environment) without memory.
bool is_damaged(const std::string& bytes, CodedPicture kind);

}  // namespace polhode
