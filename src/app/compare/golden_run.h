// SPDX-License-Identifier: MIT
// The command `golden run`: checks that scenes still look like their references.
#pragma once

#include "app/compare/golden_job.h"

namespace polhode {

// Renders every case and compares it with each of its references; the best match counts. Does not
// change references. Failed cases leave NAME.actual.png and NAME.difference.png in job.output;
// those of cases that pass are removed. Throws Error as load_cases and draw_cases do, and (input)
// naming --output if the folder cannot be created.
GoldenResult golden_run(const GoldenJob& job);

}  // namespace polhode
