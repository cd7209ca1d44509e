// SPDX-License-Identifier: MIT
// Speed against accuracy of pictures: what each drawing setting costs, and how far its pictures are
// from heavily supersampled ones.
#pragma once

#include <string>

#include "app/commands/chart.h"

namespace polhode {

// chart.csv with the columns scene,setting,samples,supersampling,time_ms,rmse_levels,
// max_levels, and the pictures of it. Throws Error.
std::string chart_pictures(const ChartJob& job);

}  // namespace polhode
