// SPDX-License-Identifier: MIT
// Colours as scene files write them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace polhode {

// "#rrggbb" as its three bytes red, green, blue. Throws Error (input) for anything else.
std::array<std::uint8_t, 3> parse_color(std::string_view text);

}  // namespace polhode
