// SPDX-License-Identifier: MIT
#include "base/error.h"

namespace polhode {
namespace {

// control characters would break the promise of one line (and could drive a terminal)
std::string one_line(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n' || c == '\t') {
      out += ' ';
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      out += c;
    }
  }
  return out;
}

std::string full_line(const std::string& message, const Place& place) {
  std::string line;
  if (!place.file.empty()) line += place.file + ":";
  if (place.line > 0) line += fmt::format("{}:", place.line);
  if (!line.empty()) line += ' ';
  if (!place.key.empty()) line += place.key + ": ";
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
