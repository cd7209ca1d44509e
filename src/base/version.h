// SPDX-License-Identifier: MIT
// The version of the program.
#pragma once

#include <string>

namespace polhode {

std::string program_version();

}  // namespace polhode
