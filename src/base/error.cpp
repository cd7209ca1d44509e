// SPDX-License-Identifier: MIT
#include "base/error.h"

#include "base/one_line.h"

namespace polhode {
namespace {

std::string full_line(const std::string& message, const Place& place) {
  std::string line;
  if (!place.file.empty()) line += place.file + ":";
  if (place.line > 0) line += fmt::format("{}:", place.line);
  if (!line.empty()) line += ' ';
  // keys may be as long as somebody writes them
  constexpr std::size_t kLongestKey = 500;
  if (!place.key.empty()) line += cut(place.key, kLongestKey) + ": ";
  return one_line(line + message);
}

}  // namespace

Error::Error(Fault fault, const std::string& message, const Place& place)
    : std::runtime_error(full_line(message, place)),
      fault_(fault),
      message_(message),
      place_(place) {}

Error Error::at(const Place& place) const {
  Place filled = place_;
  if (filled.file.empty()) filled.file = place.file;
  if (filled.line == 0) filled.line = place.line;
  if (filled.key.empty()) filled.key = place.key;
  return {fault_, message_, filled};
}

}  // namespace polhode
