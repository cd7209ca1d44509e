// SPDX-License-Identifier: MIT
// Finds the valid name closest to a mistyped one, for error messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

// The candidate with the least Damerau-Levenshtein distance to `name` (optimal string alignment:
// insertions, deletions, replacements and swaps of neighbouring bytes count 1, ASCII case is
// ignored); a whole word between underscores, as "axes" in "semi_axes", is at distance 1. The first
// of equally near ones. "" if the distance exceeds half the number of bytes of
// the name (rounded down, but at least 1), and for names of more than 200 bytes.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

// Whether the two differ by one slip of the pen at most: a distance of 1, as above.
bool is_almost(std::string_view name, std::string_view other);

// The end of an error message about an unknown name: " (did you mean 'mass'?)", or " (known: ...)"
// with all candidates if nearest_name() finds none, or " (there are none)".
std::string suggestion(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace polhode
