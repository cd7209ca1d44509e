// SPDX-License-Identifier: MIT
#include "model/given_keys.h"

#include <algorithm>

#include <fmt/ranges.h>

#include "base/error.h"

namespace polhode {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string with_article(const std::string& kind) {
  const bool begins_with_vowel = std::string("aeiou").find(kind.substr(0, 1)) != std::string::npos;
  return (begins_with_vowel ? "an " : "a ") + kind;
}

void require_keys(const std::string& kind,
                  const std::vector<std::string>& needed,
                  const std::vector<std::string>& given,
                  const std::string& path) {
  for (const std::string& name : needed) {
    if (contains(given, name)) continue;
    throw input_error("{} needs '{}'", with_article(kind), name).at({{}, 0, path});
  }
}

void refuse_other_keys(const std::string& kind,
                       const std::vector<std::string>& known,
                       const std::vector<std::string>& given,
                       const std::string& path) {
  for (const std::string& name : given) {
    if (contains(known, name)) continue;
    throw input_error(
        "{} has no '{}'; it takes {}", with_article(kind), name, fmt::join(known, ", "))
        .at({{}, 0, fmt::format("{}.{}", path, name)});
  }
}

}  // namespace polhode
