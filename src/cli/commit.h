// SPDX-License-Identifier: MIT
// The commit that this program was built from.
#pragma once

namespace polhode {

// Twelve digits, with "-modified" behind them when the sources differed from it; "" where the
// sources were no git checkout. Written by write_commit.cmake in every build.
const char* program_commit();

}  // namespace polhode
