// SPDX-License-Identifier: MIT
#include "base/nearest.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polhode {
namespace {

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

// optimal string alignment distance, three rolling rows
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    above[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + change});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                           lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, above);
    std::swap(above, row);
  }
  return above[b.size()];
}

// "semi_axes" has the word "axes"
bool has_word(std::string_view candidate, std::string_view word) {
  return ("_" + std::string(candidate) + "_").find("_" + std::string(word) + "_") !=
         std::string::npos;
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t least = std::max<std::size_t>(1, name.size() / 2) + 1;
  // an absurdly long name has no near neighbour and is not worth a quadratic table
  if (name.size() > 200) return best;
  for (const std::string& candidate : candidates) {
    std::size_t d = distance(name, candidate);
    if (d > 1 && has_word(candidate, name)) d = 1;
    if (d < least) {
      least = d;
      best = candidate;
    }
  }
  return best;
}

bool is_almost(std::string_view name, std::string_view other) {
  const std::size_t shorter = std::min(name.size(), other.size());
  return std::max(name.size(), other.size()) - shorter <= 1 && distance(name, other) <= 1;
}

std::string suggestion(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string best = nearest_name(name, candidates);
  if (!best.empty()) return fmt::format(" (did you mean '{}'?)", best);
  if (candidates.empty()) return " (there are none)";
  return fmt::format(" (known: {})", fmt::join(candidates, ", "));
}

}  // namespace polhode
