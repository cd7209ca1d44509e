// SPDX-License-Identifier: MIT
// What `polhode --version` prints.
#pragma once

#include <string>

namespace polhode {

// The program with its commit ("": unknown), and the libraries that it was compiled with and those
// that it has found now, a line each.
std::string version_text(const std::string& commit);

}  // namespace polhode
