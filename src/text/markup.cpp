// SPDX-License-Identifier: MIT
#include "text/markup.h"

#include <fmt/format.h>

namespace polhode {

std::string plain_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        // XML has no other control characters
        if (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') {
          escaped += fmt::format("&#x{:x};", byte);
        } else {
          escaped += c;
        }
    }
  }
  return escaped;
}

}  // namespace polhode
