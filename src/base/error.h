// SPDX-License-Identifier: MIT
// The one exception of the program: what a user can mend, where it is, and the exit code it ends
// in.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace polhode {

// Why a run cannot go on. The value is the exit code of the process.
enum class Fault {
  check_failed = 1,   // a check said no: pictures differ, a motion turned to NaN
  input = 2,          // bad scene, bad option, bad usage
  environment = 3,    // no GL, no encoder, disk full
  interrupted = 130,  // SIGINT, SIGTERM or SIGHUP
};

// Where in the user's text the fault lies; every part may be missing.
struct Place {
  std::string file;  // as the user named it
  int line = 0;      // from 1; 0 = unknown
  std::string key;   // dotted path such as "body.mass", or an option such as "--size"
};

// One line for the user: "file:line: key: message". Thrown anywhere, caught once, in main.
class Error : public std::runtime_error {
 public:
  Error(Fault fault, const std::string& message, const Place& place = {});

  Fault fault() const { return fault_; }
  const Place& place() const { return place_; }
  // The message without its place.
  const std::string& message() const { return message_; }
  // The same error with what is still unknown of its place filled in.
  Error at(const Place& place) const;

 private:
  Fault fault_;
  std::string message_;
  Place place_;
};

template <class... Args>
Error input_error(fmt::format_string<Args...> text, Args&&... args) {
  return {Fault::input, fmt::format(text, std::forward<Args>(args)...)};
}

template <class... Args>
Error environment_error(fmt::format_string<Args...> text, Args&&... args) {
  return {Fault::environment, fmt::format(text, std::forward<Args>(args)...)};
}

}  // namespace polhode
