// SPDX-License-Identifier: MIT
// SIGINT, SIGTERM and SIGHUP set a flag that long computations poll, so that destructors clean up.
// A second signal ends the process at once.
#pragma once

#include <chrono>

namespace polhode {

// One key press often arrives as two signals, one from the terminal and one from its shell. Signals
// closer together than this count as one.
inline constexpr std::chrono::milliseconds kSameKey{500};

// Installs the handlers. Ignores SIGPIPE and SIGXFSZ, so that writes fail with an error code
// instead. Signals within `same_key` of the first one are ignored.
void watch_for_interrupt(std::chrono::milliseconds same_key = kSameKey);

// Throws Error (interrupted) if a signal has arrived. May be called from any thread.
void stop_if_interrupted();

}  // namespace polhode
