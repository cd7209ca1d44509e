// SPDX-License-Identifier: MIT
// The text of `polhode --version`.
#pragma once

#include <string>

namespace polhode {

// Four lines: the program with its commit ("": unknown, left out), compiler and libraries at
// compile time, libraries found at run time, and where the version of OpenGL is shown. The last
// line has no line break.
std::string version_text(const std::string& commit);

}  // namespace polhode
