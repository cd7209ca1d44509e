// SPDX-License-Identifier: MIT
// The version number of the program.
#pragma once

#include <string>

namespace polhode {

// The version number, such as "0.1.0". It is part of reports and of the keys of cached lecture
// media, so both are refused or made again after a change of version.
std::string program_version();

}  // namespace polhode
