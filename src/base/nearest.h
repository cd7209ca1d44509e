// SPDX-License-Identifier: MIT
// Finds the valid name closest to a mistyped one, for error messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

// The candidate with the least Damerau-Levenshtein distance to `name` (optimal string alignment,
// case ignored), or "" if more than half of the name would have to change.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

// The end of an error message: " (did you mean 'mass'?)", or " (known: ...)" with all candidates if
// none is close.
std::string suggestion(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace polhode
