// SPDX-License-Identifier: MIT
// Parses numbers. The whole text must be the number, without white space; the locale is ignored.
#pragma once

#include <optional>
#include <string_view>

namespace polhode {

// The decimal integer, such as "12" or "-3". Empty for any other text (also "+3" and "1.0") and for
// numbers that do not fit an int.
std::optional<int> parse_integer(std::string_view text);

// The decimal number, such as "2.5", "5.", ".5", "-2" or "1e-3". Empty for any other text (also
// "+2.5" and "0x10"), for infinities, for NaN, and for numbers too large or too small for a double
// ("1e400", "1e-400").
std::optional<double> parse_number(std::string_view text);

}  // namespace polhode
