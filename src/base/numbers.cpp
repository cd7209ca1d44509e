// SPDX-License-Identifier: MIT
#include "base/numbers.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>

namespace polhode {
namespace {

#if defined(__cpp_lib_to_chars) || defined(__GLIBCXX__)
using std::from_chars;
#else
// libc++ has none for floating point yet; where it is used, there is one locale
std::from_chars_result from_chars(const char* begin, const char* end, double& value) {
  const std::string text(begin, end);
  const bool begins_well =
      !text.empty() && (std::isdigit(text[0]) != 0 || text[0] == '-' || text[0] == '.');
  char* stop = nullptr;
  if (begins_well && text.find_first_of("xX") == std::string::npos)
    value = std::strtod(text.c_str(), &stop);
  const std::ptrdiff_t read = stop == nullptr ? 0 : stop - text.c_str();
  return {begin + read, read > 0 ? std::errc() : std::errc::invalid_argument};
}
using std::from_chars;
#endif

template <class Number>
std::optional<Number> whole(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, failed] = from_chars(text.data(), end, value);
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
