// SPDX-License-Identifier: MIT
// Sets up spdlog's default logger. It writes to stderr, because stdout is for data.
#pragma once

#include <spdlog/spdlog.h>

namespace polhode {

// Shows messages of the levels warning and error, and with `verbose` also those of the level info.
// main() calls it once, before any other thread logs.
void start_log(bool verbose);

}  // namespace polhode
