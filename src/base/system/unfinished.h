// SPDX-License-Identifier: MIT
// What must not be left behind when the process ends without running destructors: because a library
// aborts, or does not come back after a signal to stop.
#pragma once

#include <csignal>
#include <filesystem>
#include <string_view>

#include <sys/types.h>

namespace polhode {

// Remembers an unfinished file, a folder of temporary files or a child process until it is
// destroyed; end_at_once() removes or kills what is remembered then. Only the process that made it
// removes it, not one forked from that. Thread-safe.
class Unfinished {
 public:
  explicit Unfinished(const std::filesystem::path& path);
  explicit Unfinished(pid_t child);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

  struct Slot;  // for the implementation

 private:
  Slot* slot_;  // never null
};

// While a thread has one, no signal interrupts it, and a process that ends waits for it, for two
// seconds at most, before it removes anything: for making a thing and remembering it, or giving
// several their names. If the process ends already, the constructor does not come back, and if it
// is to end meanwhile, neither does the destructor.
class Unbroken {
 public:
  Unbroken();
  ~Unbroken();
  Unbroken(const Unbroken&) = delete;
  Unbroken& operator=(const Unbroken&) = delete;

 private:
  sigset_t before_;  // what the thread does not want to hear
};

// Whether the process ends at once and what is unfinished is being removed. Other threads go on
// until it is, or until they make a file: what they find then may have gaps.
bool is_ending();
// Does not come back then. For what would make again what has just been removed, or tell that it is
// not there.
void wait_if_ending();

// Kills a child and, if it leads a process group, the programs that it has started. May be called
// in a signal handler.
void end_with_all_it_started(pid_t child);

// Says this on standard error, unless that would have to wait for a reader or a stopped terminal.
// May be called in a signal handler.
void say_in_passing(std::string_view words);

// Removes all that is unfinished and ends the process with that exit code, without destructors.
// May be called in a signal handler.
[[noreturn]] void end_at_once(int exit_code);

// From now on, a crash (SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGTRAP, SIGSYS) or a signal that
// asks for the end without saying when (SIGQUIT, SIGXCPU, SIGUSR1, SIGUSR2, SIGVTALRM, SIGPROF)
// says so in one line on standard error and removes what is unfinished before it ends the process.
// Signals that somebody else handles, such as a sanitizer, stay as they are.
void tidy_up_after_crashes();

}  // namespace polhode
