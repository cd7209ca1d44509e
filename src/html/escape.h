// SPDX-License-Identifier: MIT
// Escapes text for HTML pages.
#pragma once

#include <string>

namespace polhode {

// Plain text as HTML, for content and attribute values. Bytes that are not UTF-8 become replacement
// characters.
std::string escaped(const std::string& text);

}  // namespace polhode
