// SPDX-License-Identifier: MIT
// The only exception type that the program throws itself: a message for the user, the place of the
// fault, and the exit code. main() turns all others that reach it, such as std::bad_alloc, into the
// exit code 3.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace polhode {

// Why a run cannot go on. The value is the exit code of the process. Comments name it in brackets:
// "Throws Error (input)".
enum class Fault {
  check_failed = 1,   // a result failed its check, such as a motion that became NaN
  input = 2,          // bad scene, bad option, bad usage
  environment = 3,    // the machine lacks something: a library, a program, memory, disk space
  interrupted = 130,  // SIGINT, SIGTERM or SIGHUP (base/system/interrupt.h)
};

// Where in the user's input the fault is; any part may be missing.
struct Place {
  std::string file;  // as the user named it; of a link that is written to, its target
  int line = 0;      // from 1; 0 = unknown
  std::string key;   // dotted path such as "body.parts[1].mass", an option such as "--size", or
                     // the command whose argument is wrong, such as "golden"
};

// what() is one line for the user, "file:line: key: message", without the missing parts of the
// place. Line breaks and tabs become spaces, other control characters \xNN. main() catches it,
// prints the line on stderr and returns the fault as the exit code.
class Error : public std::runtime_error {
 public:
  // `message`: what is wrong and what to do, one phrase without a full stop.
  Error(Fault fault, const std::string& message, const Place& place = {});

  Fault fault() const { return fault_; }
  const Place& place() const { return place_; }
  // The message without its place.
  const std::string& message() const { return message_; }
  // A copy of the error in which the missing parts of its place are taken from `place`.
  Error at(const Place& place) const;

 private:
  Fault fault_;
  std::string message_;
  Place place_;
};

// An Error (input) with a formatted message (fmt) and no place yet; at() adds one.
template <class... Args>
Error input_error(fmt::format_string<Args...> text, Args&&... args) {
  return {Fault::input, fmt::format(text, std::forward<Args>(args)...)};
}

// An Error (environment) with a formatted message (fmt) and no place yet; at() adds one.
template <class... Args>
Error environment_error(fmt::format_string<Args...> text, Args&&... args) {
  return {Fault::environment, fmt::format(text, std::forward<Args>(args)...)};
}

}  // namespace polhode
