// SPDX-License-Identifier: MIT
// Another program, run to its end with text in and text out. No shell is between.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct ChildResult {
  std::string out;  // what it wrote to standard output
  std::string err;  // and to standard error
  int status = 0;   // its exit code; 128 + n when signal n ended it
};

// Runs words[0], found on PATH, with the other words as its arguments; `input` is its standard
// input. SIGPIPE must be ignored (base/system/interrupt.h). Returns when it has ended. Throws Error
// (environment) when it cannot be started, (interrupted) when a signal asks us to stop; the program
// is then ended too.
ChildResult run_child(const std::vector<std::string>& words, std::string_view input);

}  // namespace polhode
