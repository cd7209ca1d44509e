// SPDX-License-Identifier: MIT
// The commit that the program was built from, and its date.
#pragma once

namespace polhode {

// The value of POLHODE_COMMIT if that was set for the build; else the first twelve or more
// hexadecimal digits, with "-modified" appended if tracked files differed from the commit; "" if
// the sources were no git checkout. write_commit.cmake defines both functions in every build.
const char* program_commit();

// The date of the commit, such as "2026-01-31"; without a git checkout, that of CHANGELOG.md.
const char* program_date();

}  // namespace polhode
