// SPDX-License-Identifier: MIT
// Ends the program cleanly on SIGINT, SIGTERM and SIGHUP: the first signal sets a flag that long
// computations poll by stop_if_interrupted(), whose exception runs the destructors. If that has not
// ended the process after two seconds, or if a second signal comes, it ends at once, and what is
// unfinished is removed (base/system/unfinished.h).
#pragma once

#include <chrono>

namespace polhode {

// One key press often arrives as two signals, one from the terminal and one from its shell. Signals
// closer together than this count as one.
inline constexpr std::chrono::milliseconds kSameKey{500};

// Installs the handlers. Signals within `same_key` after the first one are ignored. SIGPIPE and
// SIGXFSZ are ignored too, so that the writes that cause them fail with an error code instead, and
// SIGCHLD is not, and none of these is blocked, whatever the parent of the process does.
// Calls tidy_up_after_crashes(). main() calls it once; other values of `same_key` are for tests.
void watch_for_interrupt(std::chrono::milliseconds same_key = kSameKey);

// From here on no interrupt says a word: main() is about to say why the program ends.
void end_silently();

// Throws Error (interrupted) if a signal has arrived; from then on every call throws. May be called
// from any thread.
void stop_if_interrupted();

}  // namespace polhode
