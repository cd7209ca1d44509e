// SPDX-License-Identifier: MIT
#include "base/color.h"

#include <cmath>

#include "base/error.h"

namespace polhode {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::array<std::uint8_t, 3> parse_color(std::string_view text) {
  bool valid = text.size() == 7 && text[0] == '#';
  for (std::size_t i = 1; valid && i < text.size(); ++i)
    valid = hex_digit(text[i]) >= 0;
  if (!valid) {
    throw input_error("must be a colour \"#rrggbb\", such as \"#ff8800\"; found \"{}\"",
                      text.substr(0, 40));
  }
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t i = 0; i < 3; ++i) {
    bytes[i] =
        static_cast<std::uint8_t>(16 * hex_digit(text[1 + 2 * i]) + hex_digit(text[2 + 2 * i]));
  }
  return bytes;
}

double linear_of_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace polhode
