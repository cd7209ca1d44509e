// SPDX-License-Identifier: MIT
// The command `golden update`: accepts what scenes look like now.
#pragma once

#include "app/compare/golden_job.h"

namespace polhode {

// Draws every case and writes the references that are missing or no longer match, all together and
// after all could be drawn. Throws Error (input) when the folder's git tree holds changes, unless
// allowed.
GoldenResult golden_update(const GoldenJob& job);

}  // namespace polhode
