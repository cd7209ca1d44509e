// SPDX-License-Identifier: MIT
// Text of others, such as file names, safe to print within a line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

// The text with line breaks and tabs as spaces and other control characters as \xNN: they would
// break the line, and could drive a terminal. UTF-8 stays as it is.
std::string one_line(const std::string& text);

// At most the first `most` bytes of a text, for messages, followed by "..." if something is cut
// off. Never splits a UTF-8 character.
std::string cut(std::string_view text, std::size_t most = 40);

}  // namespace polhode
