// SPDX-License-Identifier: MIT
// The command `golden show`: which cases and references there are.
#pragma once

#include "app/compare/golden_job.h"

namespace polhode {

// Lists cases, references and what the sidecars say. Draws nothing.
GoldenResult golden_show(const GoldenJob& job);

}  // namespace polhode
