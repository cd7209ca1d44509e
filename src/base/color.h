// SPDX-License-Identifier: MIT
// Colours: those of scene files, "#rrggbb", and their light.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace polhode {

// The value of one hexadecimal digit, -1 for any other character.
int hex_digit(char c);

// The red, green and blue bytes (sRGB) of "#rrggbb"; the digits may be upper or lower case. Throws
// Error (input), without a place, for anything else.
std::array<std::uint8_t, 3> parse_color(std::string_view text);

// The light of an sRGB-encoded value (IEC 61966-2-1), both 0..1.
double linear_of_srgb(double encoded);

}  // namespace polhode
