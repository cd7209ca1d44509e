// SPDX-License-Identifier: MIT
// The text of `polhode --version`.
#pragma once

#include <string>

namespace polhode {

// One line each for the program (with its commit, "": unknown), the libraries that it was compiled
// with, and the libraries found at run time.
std::string version_text(const std::string& commit);

}  // namespace polhode
