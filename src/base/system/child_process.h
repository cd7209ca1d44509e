// SPDX-License-Identifier: MIT
// Runs another program to its end, without a shell, and collects its output.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

// What a program may use before it is killed.
struct ChildLimits {
  double seconds = 600.0;  // of time on the clock
  // bytes that it may write to (RLIMIT_DATA); absent: no limit, as browsers and sanitizers need
  std::optional<std::size_t> memory = {};
  std::size_t output = std::size_t{1} << 30U;  // bytes of standard output and error
};

// What a program has written, and how it ended.
struct ChildResult {
  std::string out;  // its standard output
  std::string err;  // its standard error
  int status = 0;   // its exit code, or 128 + n if signal n ended it
  // why it was killed: "took longer than 600 s"; empty if it ended by itself
  std::string exceeded;
};

// Runs words[0] (found on PATH if it has no slash) with the other words as arguments and `input` as
// its standard input, and waits for it to end. It is killed when it exceeds the limit of time or
// output; memory beyond its limit is refused to it. It inherits the environment and the working
// folder. An exit code other than 0 is not an error. SIGPIPE must be ignored
// (base/system/interrupt.h), because the program may exit before it has read its input.
// Thread-safe. Throws Error (environment) if the program cannot be started, and (interrupted) after
// SIGINT, SIGTERM or SIGHUP; the program is then killed.
ChildResult run_child(const std::vector<std::string>& words,
                      std::string_view input,
                      const ChildLimits& limits = {});

}  // namespace polhode
