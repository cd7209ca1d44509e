// SPDX-License-Identifier: MIT
// The valid name that a mistyped one most likely meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

// The candidate with the least Damerau-Levenshtein distance to `name` (optimal string alignment,
// case ignored), or "" when even the best one needs more than half of the name changed.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

// " (did you mean 'mass'?)", or the whole list when nothing is near, ready to end a message.
std::string suggestion(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace polhode
