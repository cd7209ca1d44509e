// SPDX-License-Identifier: MIT
// Colours as scene files write them: in hexadecimal digits.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace polhode {

// The value of one hexadecimal digit, -1 for any other character.
int hex_digit(char c);

// "#rrggbb" as its three bytes red, green, blue. Throws Error (input) for anything else.
std::array<std::uint8_t, 3> parse_color(std::string_view text);

}  // namespace polhode
