// SPDX-License-Identifier: MIT
// The use case `stability`: maps of where methods fail.
#pragma once

#include <string>

#include "app/commands/stability_job.h"

namespace polhode {

// Writes stability.csv, a picture per scene and method, and one overview per scene, into the
// folder. What is finished when it is interrupted is kept there and taken up by the next run with
// the same words. Returns a summary, a line per method. Throws Error.
std::string stability(const StabilityJob& job);

}  // namespace polhode
