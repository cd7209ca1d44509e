// SPDX-License-Identifier: MIT
// Runs another program to its end, without a shell, collects its output, and words how it ended.
#pragma once

#include <cstddef>
#include <functional>
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
  int signal = 0;   // the signal that ended it; 0: none
  // why it was killed: "took longer than 600 s"; empty if it ended by itself
  std::string exceeded;
};

// Runs words[0] (found on PATH if it has no slash) with the other words as arguments and `input` as
// its standard input, and waits for it to end; programs of its process group that it has left
// behind are killed then, and gone when this returns. It is killed when it exceeds the limit of
// time or output, with all that it has started; memory beyond its limit is refused to it. It
// inherits the environment and the working folder. An exit code other than 0 is not an error.
// SIGPIPE must be ignored (base/system/interrupt.h), because the program may exit before it has
// read its input. `meanwhile` is called while it runs, at least ten times a second. A limit of
// memory is set by prlimit (util-linux), which exits with 127 if it cannot start the program.
// Thread-safe. Throws Error (environment), "gnuplot is not installed" or "gnuplot cannot be
// started: Too many open files", or if what it writes cannot be read, and (interrupted) after
// SIGINT, SIGTERM or SIGHUP; the program is then killed.
ChildResult run_child(const std::vector<std::string>& words,
                      std::string_view input,
                      const ChildLimits& limits = {},
                      const std::function<void()>& meanwhile = {});

// Whether it ended by itself, with the exit code 0.
bool ended_well(const ChildResult& result);

// How it ended, for a message whose subject is the program: "took longer than 30 s", "was ended by
// signal 11 (Segmentation fault)", "ended with exit code 7: " and the first line of its standard
// error.
std::string how_it_ended(const ChildResult& result);

// What a program says of itself.
struct ProgramFound {
  std::string version;  // the first line of `PROGRAM --version`; empty if it does not run
  std::string
      why_not;  // "gnuplot is not installed", "gnuplot took longer than 25 s"; empty if it runs
  bool installed = true;  // false: there is no such program
};
// Runs `PROGRAM --version`, for at most 25 s. Throws Error (interrupted).
ProgramFound find_program(const std::string& program);

// Throws Error (environment) if the program does not run: "the deck cannot be read: pandoc is not
// installed; install it (…)", with `what` as its first words and `advice`, which is told only where
// the program is missing, as its last; and (interrupted). Call it before long work that needs it.
void require_program(const std::string& program,
                     const std::string& what,
                     const std::string& advice);

}  // namespace polhode
