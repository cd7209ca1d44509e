// SPDX-License-Identifier: MIT
// Escapes text for HTML pages.
#pragma once

#include <string>

namespace polhode {

// Plain text as HTML, for content and quoted attribute values. Bytes that are not UTF-8 become the
// replacement character U+FFFD, control characters (line breaks too) become spaces.
std::string escaped(const std::string& text);

}  // namespace polhode
