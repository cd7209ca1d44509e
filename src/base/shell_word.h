// SPDX-License-Identifier: MIT
// File names in commands that a message asks the reader to type.
#pragma once

#include <string>

namespace polhode {

// The name as one word of a POSIX shell, in quotes where it needs them; "./" keeps a name that
// begins with a dash from being an option.
std::string shell_word(const std::string& name);

}  // namespace polhode
