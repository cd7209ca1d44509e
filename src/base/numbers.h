// SPDX-License-Identifier: MIT
// Parses numbers. The whole text must be the number, without white space; the locale is ignored.
#pragma once

#include <optional>
#include <string_view>

namespace polhode {

// The decimal integer, such as "12" or "-3". Empty for any other text (also "+3" and "1.0") and for
// numbers that do not fit an int.
std::optional<int> parse_integer(std::string_view text);

// The decimal number, such as "2.5" or "1e-3". Empty for any other text, for infinities, for NaN
// and for numbers out of range of a double.
std::optional<double> parse_number(std::string_view text);

}  // namespace polhode
