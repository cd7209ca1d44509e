// SPDX-License-Identifier: MIT
// From bytes to a TOML tree, with everything refused that is not a small, sane text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace polhode {

inline constexpr std::size_t kLargestScene = 16'000'000;  // bytes
inline constexpr int kDeepestNesting = 32;  // brackets in brackets, or dots in one key

// Throws Error (input) with file and line for empty text, bytes that are not UTF-8, nesting that
// could exhaust the stack, and every fault of TOML's grammar. `name` stands for the file in
// messages.
toml::table parse_toml(std::string_view text, const std::string& name);

// At most `most` bytes of the user's text, for messages; never cuts a UTF-8 character in two.
std::string cut(std::string_view text, std::size_t most = 40);

}  // namespace polhode
