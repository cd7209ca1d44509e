// SPDX-License-Identifier: MIT
// The commit that this program was built from.
#pragma once

namespace polhode {

// Twelve digits, with "-modified" behind them when the sources differed from it; "" where the
// sources were no git checkout. Written by write_commit.cmake in every build.
const char* program_commit();

// Its day, "2026-01-31"; of an archive, that of its changelog.
const char* program_date();

}  // namespace polhode
