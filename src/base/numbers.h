// SPDX-License-Identifier: MIT
// Parses numbers: the whole text must be the number, without white space; the locale is ignored.
// And compares them where they have round-off.
#pragma once

#include <limits>
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

// t, or `end` if t is more by round-off alone: 3 * 0.7 is less than 2.1. Neither is negative.
inline double up_to(double end, double t) {
  constexpr double kRoundOff = 4.0 * std::numeric_limits<double>::epsilon();
  return t > end && t <= end * (1.0 + kRoundOff) ? end : t;
}

}  // namespace polhode
