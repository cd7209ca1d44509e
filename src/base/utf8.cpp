// SPDX-License-Identifier: MIT
#include "base/utf8.h"

#include <algorithm>

#include "base/error.h"

namespace polhode {

bool is_continuation(std::string_view text, std::size_t i) {
  return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80;
}

std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) {
    return static_cast<unsigned char>(text[k]);
  };
  const unsigned char lead = byte(i);
  if (lead < 0x80) return 1;
  const std::size_t length = lead < 0xc2   ? 0
                             : lead < 0xe0 ? 2
                             : lead < 0xf0 ? 3
                             : lead < 0xf5 ? 4
                                           : 0;
  for (std::size_t k = 1; k < length; ++k) {
    if (!is_continuation(text, i + k)) return 0;
  }
  // no overlong forms, no surrogates, nothing beyond U+10FFFF
  if (lead == 0xe0 && byte(i + 1) < 0xa0) return 0;
  if (lead == 0xed && byte(i + 1) >= 0xa0) return 0;
  if (lead == 0xf0 && byte(i + 1) < 0x90) return 0;
  if (lead == 0xf4 && byte(i + 1) >= 0x90) return 0;
  return length;
}

std::size_t find_unwritable(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool is_control = byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r';
    if (is_control || byte == 0x7f) return i;
    const std::string_view last = text.substr(i, 3);
    if (last == "\xef\xbf\xbe" || last == "\xef\xbf\xbf") return i;
  }
  return std::string_view::npos;
}

std::string code_point(std::string_view text, std::size_t i) {
  const std::size_t length = std::max<std::size_t>(1, utf8_length(text, i));
  unsigned value = static_cast<unsigned char>(text[i]);
  if (length > 1) value &= 0x7fU >> length;
  for (std::size_t k = 1; k < length; ++k)
    value = value << 6U | (static_cast<unsigned char>(text[i + k]) & 0x3fU);
  return fmt::format("U+{:04X}", value);
}

void refuse_other_encodings(std::string_view text, const std::string& name, const char* kind) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = text[i] == 0 ? 0 : utf8_length(text, i);
    if (length == 0) {
      const auto line =
          1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i), '\n');
      throw input_error("byte 0x{:02x} is not UTF-8 text; save the {} as UTF-8",
                        static_cast<unsigned char>(text[i]),
                        kind)
          .at({name, static_cast<int>(line), {}});
    }
    i += length;
  }
}

}  // namespace polhode
