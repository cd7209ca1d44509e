// SPDX-License-Identifier: MIT
// Protects input files from being overwritten by a mistyped output name.
#pragma once

#include <filesystem>
#include <string>

namespace polhode {

// Throws Error (input), without a key, if the output `written` is the input file `needed` or ends
// in .toml. `what` names the output in the message. An empty name is accepted.
void refuse_same_file(const std::string& written,
                      const std::string& what,
                      const std::filesystem::path& needed);

}  // namespace polhode
