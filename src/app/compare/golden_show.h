// SPDX-License-Identifier: MIT
// The command `golden show`: lists cases and references.
#pragma once

#include "app/compare/golden_job.h"

namespace polhode {

// Lists the cases, their references and the content of the sidecars, without rendering. The exit
// code is 0. Throws Error as load_cases (app/compare/golden_cases.h) does.
GoldenResult golden_show(const GoldenJob& job);

}  // namespace polhode
