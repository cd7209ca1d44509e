// SPDX-License-Identifier: MIT
// JSON whose objects keep the order in which their keys were added.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace polhode {

using Json = nlohmann::ordered_json;

// Parses what anybody may have written. Null if it is no JSON, or nested deeper than 100 levels:
// what walks over values, copies or writes them recurs. Does not throw.
Json parse_foreign_json(const std::string& text);

}  // namespace polhode
