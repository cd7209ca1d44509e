// SPDX-License-Identifier: MIT
// Runs another program to its end, without a shell, and collects its output.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

// What a program has written, and how it ended.
struct ChildResult {
  std::string out;  // all of its standard output
  std::string err;  // all of its standard error
  int status = 0;   // its exit code, or 128 + n if signal n ended it
};

// Runs words[0] (found on PATH if it has no slash) with the other words as arguments and `input` as
// its standard input, and waits for it to end. It inherits the environment and the working folder.
// An exit code other than 0 is not an error. SIGPIPE must be ignored (base/system/interrupt.h),
// because the program may exit before it has read its input. Thread-safe. Throws Error
// (environment) if the program cannot be started, and (interrupted) after SIGINT, SIGTERM or
// SIGHUP; the program is then killed.
ChildResult run_child(const std::vector<std::string>& words, std::string_view input);

}  // namespace polhode
