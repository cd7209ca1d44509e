// SPDX-License-Identifier: MIT
#include "base/numbers.h"

#include <charconv>
#include <cmath>

namespace polhode {
namespace {

template <class Number>
std::optional<Number> whole(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, value);
  if (text.empty() || failed != std::errc() || stop != end) return {};
  return value;
}

}  // namespace

std::optional<int> parse_integer(std::string_view text) {
  return whole<int>(text);
}

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> value = whole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace polhode
