// SPDX-License-Identifier: MIT
// The version of the program.
#pragma once

#include <string>

namespace polhode {

// "0.1.0": part of reports, and of what pictures are kept by.
std::string program_version();

// What `polhode --version` prints: the program with its commit ("": unknown), and the libraries
// that it was compiled with and that it has found now, a line each.
std::string version_text(const std::string& commit);

}  // namespace polhode
