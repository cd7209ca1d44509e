// SPDX-License-Identifier: MIT
// The command `golden run`: checks that scenes still look like their references.
#pragma once

#include "app/compare/golden_job.h"

namespace polhode {

// Renders the cases in job.cases and compares each with all its references; the best match
// counts. Does not change references. Cases that fail leave NAME.actual.png and, if there is a
// reference of the same size, NAME.difference.png in job.output; those of an earlier run are
// removed first, also for cases that pass or cannot be rendered. Writes the HTML page if it is
// asked for. Throws Error as load_cases (app/compare/golden_cases.h) and draw_cases
// (app/compare/golden_results.h) do; (input) with --output or --html as key if that folder cannot
// be created, or if --output is job.folder; and as AtomicFile (base/system/atomic_file.h) does for
// the pictures and the page; (environment) if one cannot be written.
GoldenResult golden_run(const GoldenJob& job);

}  // namespace polhode
