// SPDX-License-Identifier: MIT
// SIGINT, SIGTERM and SIGHUP become a flag that long work looks at; clean-up is then ordinary
// unwinding. A second signal, when the user asks again, ends the process at once.
#pragma once

#include <chrono>

namespace polhode {

// One key often arrives as two signals: from the terminal and from its shell.
inline constexpr std::chrono::milliseconds kSameKey{500};

// Installs the handlers; ignores SIGPIPE and SIGXFSZ so that writes fail with an error code
// instead. Signals within `same_key` of the first count as the first.
void watch_for_interrupt(std::chrono::milliseconds same_key = kSameKey);

// Throws Error (interrupted) once a signal has come.
void stop_if_interrupted();

}  // namespace polhode
