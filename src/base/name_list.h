// SPDX-License-Identifier: MIT
// Lists of names as options take them.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

// The names in "a,b"; none in "".
std::vector<std::string> split_names(std::string_view list);

// Those names once each. Throws Error (input) at the option, "no case is called 'x'" (what:
// "case"), for one that is not known.
std::set<std::string> known_names(std::string_view list,
                                  const std::vector<std::string>& known,
                                  std::string_view what,
                                  const std::string& option);

}  // namespace polhode
