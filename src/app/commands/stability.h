// SPDX-License-Identifier: MIT
// The command `stability`: maps of how methods fail over two parameters.
#pragma once

#include <string>

#include "app/commands/stability_job.h"

namespace polhode {

// Writes stability.csv, a picture per scene and method, and an overview per scene into the folder.
// If it is interrupted, finished cells are kept there for the next run with the same options.
// Returns a summary, one line per method. Throws Error (input) as make_place does, naming --y for
// equal axes, and for two scenes of the same name; (environment) without gnuplot; (interrupted).
std::string stability(const StabilityJob& job);

}  // namespace polhode
