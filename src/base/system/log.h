// SPDX-License-Identifier: MIT
// Sets up spdlog's default logger. It writes to stderr, because stdout is for data.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <spdlog/spdlog.h>

namespace polhode {

// Shows messages of the levels warning and error, and with `verbose` also those of the level info.
// main() calls it once, before any other thread logs.
void start_log(bool verbose);

// Runs `work` and returns the warnings that this thread gives meanwhile, each once, in their order.
// They are not written, unless `work` throws. Before start_log() there are none.
std::vector<std::string> warnings_of(const std::function<void()>& work);

}  // namespace polhode
