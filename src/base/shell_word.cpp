// SPDX-License-Identifier: MIT
#include "base/shell_word.h"

#include <string_view>

namespace polhode {

std::string shell_word(const std::string& name) {
  return shell_quoted(name.starts_with('-') ? "./" + name : name);
}

std::string shell_quoted(const std::string& text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-+,:@%=";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted;
  for (const char c : text)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return "'" + quoted + "'";
}

}  // namespace polhode
