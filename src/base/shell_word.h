// SPDX-License-Identifier: MIT
// Words of commands for a shell: that a message asks the reader to type, or in scripts.
#pragma once

#include <string>

namespace polhode {

// The name as one word of a POSIX shell, in quotes where it needs them; "./" keeps a name that
// begins with a dash from being an option.
std::string shell_word(const std::string& name);

// Any text as one word of a POSIX shell, in quotes where it needs them; a dash stays a dash.
std::string shell_quoted(const std::string& text);

}  // namespace polhode
