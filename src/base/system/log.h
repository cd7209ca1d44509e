// SPDX-License-Identifier: MIT
// Sets up spdlog's default logger. It writes to stderr, because stdout is for data.
#pragma once

#include <spdlog/spdlog.h>

namespace polhode {

// Shows warnings and errors, and with `verbose` also information. main calls it once.
void start_log(bool verbose);

}  // namespace polhode
