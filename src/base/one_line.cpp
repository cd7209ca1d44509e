// SPDX-License-Identifier: MIT
#include "base/one_line.h"

#include <fmt/format.h>

#include "base/utf8.h"

namespace polhode {

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

std::string cut(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  while (most > 0 && is_continuation(text, most))
    --most;
  return std::string(text.substr(0, most)) + "...";
}

}  // namespace polhode
