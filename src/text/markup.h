// SPDX-License-Identifier: MIT
// The markup of texts: what Pango reads, and labels in pages.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

// Escapes plain text for use as markup.
std::string plain_text(std::string_view text);

}  // namespace polhode
