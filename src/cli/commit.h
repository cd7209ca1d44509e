// SPDX-License-Identifier: MIT
// The commit that the program was built from.
#pragma once

namespace polhode {

// Twelve digits, with "-modified" appended if the sources differed from the commit; "" if they were
// not a git checkout. write_commit.cmake writes it in every build.
const char* program_commit();

// The date of the commit, such as "2026-01-31"; for an archive the date of its changelog.
const char* program_date();

}  // namespace polhode
