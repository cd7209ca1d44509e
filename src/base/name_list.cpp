// SPDX-License-Identifier: MIT
#include "base/name_list.h"

#include <algorithm>

#include "base/error.h"
#include "base/nearest.h"

namespace polhode {

std::string_view trimmed(std::string_view text, std::string_view blanks) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> split_names(std::string_view list) {
  std::vector<std::string> names;
  for (std::size_t start = 0; start < list.size();) {
    const std::size_t end = std::min(list.find(',', start), list.size());
    names.emplace_back(trimmed(list.substr(start, end - start), " "));
    start = end + 1;
  }
  return names;
}

std::set<std::string> known_names(std::string_view list,
                                  const std::vector<std::string>& known,
                                  std::string_view what,
                                  const std::string& option) {
  std::set<std::string> names;
  for (const std::string& name : split_names(list)) {
    if (name.empty()) throw input_error("a name is missing in '{}'", list).at({{}, 0, option});
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw input_error("unknown {} '{}'{}", what, name, suggestion(name, known))
          .at({{}, 0, option});
    }
    names.insert(name);
  }
  return names;
}

}  // namespace polhode
