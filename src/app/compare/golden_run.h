// SPDX-License-Identifier: MIT
// The command `golden run`: checks that scenes still look like their references.
#pragma once

#include "app/compare/golden_job.h"

namespace polhode {

// Renders every case and compares it with each of its references; the best match counts. Does not
// change references. Cases that fail leave NAME.actual.png and, if there is a reference of the same
// size, NAME.difference.png in job.output; those of cases that pass are removed. Writes the HTML
// page if it is asked for. Throws Error as load_cases and draw_cases do; (input) with --output or
// --html as key if that folder cannot be created; (environment) if pictures or page cannot be
// written.
GoldenResult golden_run(const GoldenJob& job);

}  // namespace polhode
