// SPDX-License-Identifier: MIT
// Runs another program to its end, without a shell, and collects its output.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct ChildResult {
  std::string out;  // its standard output
  std::string err;  // its standard error
  int status = 0;   // its exit code; 128 + n if signal n ended it
};

// Runs words[0], found on PATH, with the other words as arguments and `input` as its standard
// input, and waits for it to end. SIGPIPE must be ignored (base/system/interrupt.h). Throws Error
// (environment) if the program cannot be started, (interrupted) after SIGINT, SIGTERM or SIGHUP;
// the program is then killed.
ChildResult run_child(const std::vector<std::string>& words, std::string_view input);

}  // namespace polhode
