// SPDX-License-Identifier: MIT
// The logger: spdlog's default one, on stderr, so that stdout stays free for data.
#pragma once

#include <spdlog/spdlog.h>

namespace polhode {

// Warnings and errors always, the rest with verbose; called once, by main.
void start_log(bool verbose);

}  // namespace polhode
