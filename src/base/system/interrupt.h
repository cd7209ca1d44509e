// SPDX-License-Identifier: MIT
// SIGINT, SIGTERM and SIGHUP become a flag that long work looks at; clean-up is then ordinary
// unwinding. A second
// signal, when the user asks again, ends the process at once.
#pragma once

namespace polhode {

// Installs the handlers; ignores SIGPIPE and SIGXFSZ so that writes fail with an error code
// instead.
void watch_for_interrupt();

// Throws Error (interrupted) once a signal has come.
void stop_if_interrupted();

}  // namespace polhode
