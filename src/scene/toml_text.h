// SPDX-License-Identifier: MIT
// Parses TOML, and refuses text that is too large, not UTF-8 or too deeply nested.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace polhode {

// The limits of parse_toml().
inline constexpr std::size_t kLargestScene = 16'000'000;  // bytes
inline constexpr int kDeepestNesting = 32;                // nested brackets, or dots in one key

// Parses a TOML text; `name` is the file name for messages, and `least` what the file needs, such
// as "a scene needs at least a [body] table". Throws Error (input) with the file for empty text and
// text of more than kLargestScene bytes; with file and line for bytes that are not UTF-8, nesting
// deeper than kDeepestNesting, and syntax errors.
toml::table parse_toml(std::string_view text,
                       const std::string& name,
                       const std::string& least = "a scene needs at least a [body] table");

}  // namespace polhode
