// SPDX-License-Identifier: MIT
// The commit that the program was built from, and its date.
#pragma once

namespace polhode {

// The commit: the value of the environment variable POLHODE_COMMIT if that was set for the build;
// else the first twelve or more hexadecimal digits of the hash, with "-modified" appended if
// tracked files differed from the commit; "" if the sources were no git checkout or git was
// missing. The returned text is static. write_commit.cmake writes the source file of both functions
// in every build.
const char* program_commit();

// The date of the commit, such as "2026-01-31"; if there was no git checkout or POLHODE_COMMIT was
// set, the date (UTC) when the file CHANGELOG.md was last changed. The returned text is static.
const char* program_date();

}  // namespace polhode
