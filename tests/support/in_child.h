// SPDX-License-Identifier: MIT
// Work in a child process, for what would change or end the process of the tests.
#pragma once

#include <csignal>
#include <cstdio>
#include <unistd.h>

#include <sys/wait.h>

namespace polhode::test {

// The exit code that `work` returns; -1 when the child ended otherwise.
template <class Work>
int exit_code_in_child(const Work& work) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGHUP, SIG_DFL);  // whatever runs the tests
    _exit(work());
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace polhode::test
