// SPDX-License-Identifier: MIT
// A disk that is full after so many bytes, for one piece of work in a child process.
#pragma once

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <unistd.h>

#include <sys/resource.h>
#include <sys/wait.h>

#include "base/error.h"

namespace polhode::test {

enum class Outcome { done = 0, environment = 3, other_error = 4, crashed = 5 };

// Runs the work where no file may grow beyond `most` bytes, and tells how it ended.
template <class Work>
Outcome with_full_disk(rlim_t most, const Work& work) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{most, most};
    setrlimit(RLIMIT_FSIZE, &limit);
    Outcome outcome = Outcome::done;
    try {
      work();
    } catch (const Error& error) {
      outcome = error.fault() == Fault::environment ? Outcome::environment : Outcome::other_error;
    } catch (const std::exception&) {
      outcome = Outcome::other_error;
    }
    _exit(static_cast<int>(outcome));
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) {
    return Outcome::crashed;
  }
  return static_cast<Outcome>(WEXITSTATUS(status));
}

}  // namespace polhode::test
