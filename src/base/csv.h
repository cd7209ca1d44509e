// SPDX-License-Identifier: MIT
// Text as a field of a table of comma-separated values (RFC 4180).
#pragma once

#include <string>

namespace polhode {

// As it is, or in quotes when it holds a comma, a quote or a line break.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace polhode
