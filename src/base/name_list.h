// SPDX-License-Identifier: MIT
// Splits and checks options that take a list of names, such as "--cases a,b".
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

// "a,b" as {"a", "b"}; "" as an empty list.
std::vector<std::string> split_names(std::string_view list);

// The set of names in `list`. Throws Error (input) that names `option` and suggests the nearest
// name if one is not in `known`. `what` says in the message what the names stand for: "unknown case
// 'x'".
std::set<std::string> known_names(std::string_view list,
                                  const std::vector<std::string>& known,
                                  std::string_view what,
                                  const std::string& option);

}  // namespace polhode
