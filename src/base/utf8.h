// SPDX-License-Identifier: MIT
// Characters in bytes.
#pragma once

#include <cstddef>
#include <string_view>

namespace polhode {

// Is byte i there, and not the first of a character?
bool is_continuation(std::string_view text, std::size_t i);

// How many bytes the UTF-8 character at i takes; 0 when it is none (Unicode 15, table 3-7).
std::size_t utf8_length(std::string_view text, std::size_t i);

}  // namespace polhode
