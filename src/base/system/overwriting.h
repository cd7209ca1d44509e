// SPDX-License-Identifier: MIT
// Nobody's file is overwritten by a slip of the keyboard.
#pragma once

#include <filesystem>
#include <string>

namespace polhode {

// Throws Error (input) when the file `written`, called `what` in the message, is the one that is
// `needed`, or has the ending of scene files. An empty name is no file.
void refuse_same_file(const std::string& written,
                      const std::string& what,
                      const std::filesystem::path& needed);

}  // namespace polhode
