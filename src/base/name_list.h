// SPDX-License-Identifier: MIT
// Trims texts; splits and checks options that take a list of names, such as "--cases a,b".
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

// The part of `text` between the `blanks` at its ends.
std::string_view trimmed(std::string_view text, std::string_view blanks = " \t\n");

// The names between the commas, without the blanks around them: "a, b" gives {"a", "b"}, and ""
// gives an empty list. "a,,b" gives an empty name in the middle; a comma at the end is ignored.
std::vector<std::string> split_names(std::string_view list);

// The set of names in `list` (separated by commas); empty for "". Throws Error (input), with
// `option` as key, if a name is empty or not in `known`; the message suggests the nearest known
// name. `what` is the noun for the message: with "case" it reads "unknown case 'x'".
std::set<std::string> known_names(std::string_view list,
                                  const std::vector<std::string>& known,
                                  std::string_view what,
                                  const std::string& option);

}  // namespace polhode
