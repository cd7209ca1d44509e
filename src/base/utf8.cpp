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

unsigned long character_at(std::string_view text, std::size_t i) {
  const std::size_t length = utf8_length(text, i);
  unsigned long value = static_cast<unsigned char>(text[i]);
  if (length > 1) value &= 0x7fU >> length;
  for (std::size_t k = 1; k < length; ++k)
    value = value << 6U | (static_cast<unsigned char>(text[i + k]) & 0x3fU);
  return value;
}

int line_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
}

bool is_unwritable(unsigned long code_point) {
  if (code_point == '\t' || code_point == '\n' || code_point == '\r') return false;
  return code_point < 0x20 || code_point == 0x7f || code_point == 0xfffe || code_point == 0xffff;
}

std::size_t find_unwritable(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (!is_continuation(text, i) && is_unwritable(character_at(text, i))) return i;
  return std::string_view::npos;
}

std::string code_point(std::string_view text, std::size_t i) {
  return fmt::format("U+{:04X}", character_at(text, i));
}

void refuse_other_encodings(std::string_view text, const std::string& name, const char* kind) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = text[i] == 0 ? 0 : utf8_length(text, i);
    if (length == 0) {
      throw input_error("byte 0x{:02x} is not UTF-8 text; save the {} as UTF-8",
                        static_cast<unsigned char>(text[i]),
                        kind)
          .at({name, line_of(text, i), {}});
    }
    i += length;
  }
}

}  // namespace polhode
