// SPDX-License-Identifier: MIT
// The command `chart --pictures`: the time of each drawing setting against the difference of its
// pictures from heavily supersampled ones.
#pragma once

#include <string>

#include "app/commands/chart.h"

namespace polhode {

// Writes chart.csv, with the columns of picture_error_csv(), and its charts into the folder.
// Returns a summary. Throws Error (input) naming --size for pictures that are too large, and as
// chart() and open_context() do.
std::string chart_pictures(const ChartJob& job);

}  // namespace polhode
