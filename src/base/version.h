// SPDX-License-Identifier: MIT
// The version number of the program.
#pragma once

#include <string>

namespace polhode {

// The version number, such as "0.1.0". It is part of reports, which other versions refuse, and of
// the keys of cached lecture media, which other versions make again.
std::string program_version();

}  // namespace polhode
