// SPDX-License-Identifier: MIT
// Text of others, such as file names, safe to print within a line.
#pragma once

#include <string>

namespace polhode {

// The text with line breaks and tabs as spaces and other control characters as \xNN: they would
// break the line, and could drive a terminal. UTF-8 stays as it is.
std::string one_line(const std::string& text);

}  // namespace polhode
