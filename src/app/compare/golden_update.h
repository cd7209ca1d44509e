// SPDX-License-Identifier: MIT
// The command `golden update`: makes the present pictures the references.
#pragma once

#include "app/compare/golden_job.h"

namespace polhode {

// Renders every case and writes the references, with their sidecars, that are missing or do not
// match (with job.all also those that match within their thresholds but not exactly). Nothing is
// written unless all cases could be rendered. The exit code is 0. Throws Error as load_cases and
// draw_cases do; (input) with --cause as key for an invalid name, with the folder as place if git
// does not track it or its tree has uncommitted changes, unless job.allow_dirty, and without a
// place if a case cannot be rendered; (environment) if git cannot be started or a file cannot be
// written.
GoldenResult golden_update(const GoldenJob& job);

}  // namespace polhode
