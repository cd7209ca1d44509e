// SPDX-License-Identifier: MIT
// Numbers from text. All of the text must be the number; no locale, no white space around it.
#pragma once

#include <optional>
#include <string_view>

namespace polhode {

// "12", "-3"; none for anything else, and for what does not fit an int.
std::optional<int> parse_integer(std::string_view text);

// "2.5", "1e-3"; none for anything else, for infinities and NaN.
std::optional<double> parse_number(std::string_view text);

}  // namespace polhode
