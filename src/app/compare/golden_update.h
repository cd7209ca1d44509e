// SPDX-License-Identifier: MIT
// The command `golden update`: makes the present pictures the references.
#pragma once

#include "app/compare/golden_job.h"

namespace polhode {

// Renders every case and writes the references that are missing or do not match, together and only
// if all cases could be rendered. Throws Error as load_cases and draw_cases do, (input) naming
// --cause for an invalid name, and (input), with the folder as place, if git does not track it or
// its git tree has changes, unless job.allow_dirty.
GoldenResult golden_update(const GoldenJob& job);

}  // namespace polhode
