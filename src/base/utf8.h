// SPDX-License-Identifier: MIT
// Finds characters of UTF-8 text, and its lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

// Whether byte i exists and is a continuation byte (10xxxxxx). False beyond the end of the text.
bool is_continuation(std::string_view text, std::size_t i);

// The number of bytes, 1 to 4, of the UTF-8 character that begins at byte i; 0 if the bytes there
// are not valid UTF-8 (Unicode 15, table 3-7). Requires i < text.size().
std::size_t utf8_length(std::string_view text, std::size_t i);

// The number (code point) of the character that begins at byte i, or that byte if it begins none.
// Requires i < text.size().
unsigned long character_at(std::string_view text, std::size_t i);

// The line, from 1, of the byte at this offset.
int line_of(std::string_view text, std::size_t offset);

// Whether not every document and tag of a film can hold a character (XML 1.0, 2.2, and TeX): a
// control character below U+0080 other than tab and ends of lines, U+FFFE and U+FFFF.
bool is_unwritable(unsigned long code_point);

// Where the first of them stands; npos if there is none.
std::size_t find_unwritable(std::string_view text);

// The character of UTF-8 that begins at byte i, as "U+000B". Requires i < text.size().
std::string code_point(std::string_view text, std::size_t i);

// Throws Error (input), with the file `name` and the line, at the first byte that is not part of a
// UTF-8 character, and at NUL, which no text has but one in UTF-16. `kind` says in the message what
// is to be saved as UTF-8: "scene".
void refuse_other_encodings(std::string_view text, const std::string& name, const char* kind);

}  // namespace polhode
