// SPDX-License-Identifier: MIT
// The version of the program.
#pragma once

#include <string>

namespace polhode {

// "0.1.0": part of reports, and of what pictures are kept by.
std::string program_version();

}  // namespace polhode
