// SPDX-License-Identifier: MIT
// Parses numbers. The whole text must be the number, without white space; the locale is ignored.
#pragma once

#include <optional>
#include <string_view>

namespace polhode {

// Accepts "12" and "-3". Empty for any other text and for numbers that do not fit an int.
std::optional<int> parse_integer(std::string_view text);

// Accepts "2.5" and "1e-3". Empty for any other text, for infinities and for NaN.
std::optional<double> parse_number(std::string_view text);

}  // namespace polhode
