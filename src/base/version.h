// SPDX-License-Identifier: MIT
// The version number of the program.
#pragma once

#include <string>

namespace polhode {

// Such as "0.1.0". It is part of reports and of the keys of cached lecture media.
std::string program_version();

}  // namespace polhode
