// SPDX-License-Identifier: MIT
// Plain text as the content of an HTML page.
#pragma once

#include <string>

namespace polhode {

// Text for HTML: markup becomes characters, bytes that are no UTF-8 become replacement characters.
std::string escaped(const std::string& text);

}  // namespace polhode
