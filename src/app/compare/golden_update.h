// SPDX-License-Identifier: MIT
// The command `golden update`: makes the present pictures the references.
#pragma once

#include "app/compare/golden_job.h"

namespace polhode {

// Renders the cases in job.cases. For each it writes the reference NAME.png (with job.cause:
// NAME.CAUSE.png) and its sidecar if the reference has another size, and if it is missing or
// differs by more than the thresholds of cases.toml; but a picture that matches another reference
// of its case, by the thresholds of that one's sidecar, is written only for another size. With
// job.all, every picture is written that is not equal to its reference.
//
// For a reference that is kept because it is equal or within the thresholds of cases.toml, the
// sidecar alone is rewritten if its thresholds or their reason differ from those of cases.toml. A
// missing sidecar is written only if the pixels are equal.
//
// Nothing is written unless all cases could be rendered and all their references read. If writing
// fails midway, the references that are already renamed stay. The exit
// code is 0. Throws Error as load_cases (app/compare/golden_cases.h) and draw_cases
// (app/compare/golden_results.h) do; (input) with --cause as key for an invalid name, with the
// folder as place if git does not say that its tree has no uncommitted changes, unless
// job.allow_dirty, without a place if a case cannot be rendered or a reference is damaged, and as
// AtomicFile (base/system/atomic_file.h) does for a write-protected reference, an unwritable folder
// or another run; (environment) if git cannot be started or a file cannot be written.
GoldenResult golden_update(const GoldenJob& job);

}  // namespace polhode
