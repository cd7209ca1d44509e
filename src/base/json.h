// SPDX-License-Identifier: MIT
// JSON whose objects keep the order in which their keys were added.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace polhode {

using Json = nlohmann::ordered_json;

// Parses what anybody may have written. Null if it is no JSON, if an object has a key twice, of
// which others may read another one, or more than 10,000 keys, each of which is looked for among
// all, or if it is nested deeper than 100 levels: what walks over values, copies or writes them
// recurs. Does not throw.
Json parse_foreign_json(const std::string& text);

}  // namespace polhode
