// SPDX-License-Identifier: MIT
// Quotes text for a CSV file (RFC 4180).
#pragma once

#include <string>

namespace polhode {

// The text as one field: unchanged, or in double quotes, with its quotes doubled, if it contains a
// comma, a quote or a line break.
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
