// SPDX-License-Identifier: MIT
// The command `golden run`: do scenes still look like their references?
#pragma once

#include "app/compare/golden_job.h"

namespace polhode {

// Draws every case and compares it with each of its references; the best match counts. Touches no
// reference. What fails leaves NAME.actual.png and NAME.difference.png in job.output; those of
// cases that pass are removed.
GoldenResult golden_run(const GoldenJob& job);

}  // namespace polhode
