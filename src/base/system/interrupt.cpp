// SPDX-License-Identifier: MIT
#include "base/system/interrupt.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <unistd.h>

#include "base/error.h"
#include "base/system/unfinished.h"

namespace polhode {
namespace {

// the only globals besides the logger: a signal handler has nothing else to read and write
std::atomic<std::int64_t> first_signal_ms{0};  // when it came; 0: none has
std::atomic<std::int64_t> same_key_ms{0};      // how long after it a signal is still the same
std::atomic<bool> is_silent{false};            // why the program ends has been said

// the clock may be read in a handler; never 0
std::int64_t now_ms() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000 + 1;
}

// for what does not poll the flag: libraries, or a wait for one
constexpr unsigned kPatienceSeconds = 2;

extern "C" void stop_waiting(int /*signal*/) {
  if (!is_silent && !is_ending()) say_in_passing("polhode: interrupted\n");
  end_at_once(static_cast<int>(Fault::interrupted));
}

extern "C" void remember_signal(int signal) {
  std::int64_t first = 0;
  const std::int64_t now = now_ms();
  if (first_signal_ms.compare_exchange_strong(first, now)) {
    alarm(kPatienceSeconds);
    return;
  }
  // a user who asks again wants the end at once
  if (now - first >= same_key_ms.load(std::memory_order_relaxed)) stop_waiting(signal);
}

}  // namespace

void watch_for_interrupt(std::chrono::milliseconds same_key) {
  static_assert(std::atomic<std::int64_t>::is_always_lock_free);
  same_key_ms = same_key.count();
  std::signal(SIGINT, remember_signal);
  std::signal(SIGTERM, remember_signal);
  // nohup ignores it, so that work goes on when its terminal is closed
  if (std::signal(SIGHUP, remember_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGALRM, stop_waiting);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // where a parent ignored it, nobody would tell how programs end that are started here
  std::signal(SIGCHLD, SIG_DFL);
  // nor would what a parent has blocked ever come
  sigset_t ours;
  sigemptyset(&ours);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM, SIGXCPU, SIGCHLD})
    sigaddset(&ours, signal);
  pthread_sigmask(SIG_UNBLOCK, &ours, nullptr);
  tidy_up_after_crashes();
}

void end_silently() {
  is_silent = true;
}

void stop_if_interrupted() {
  if (first_signal_ms.load(std::memory_order_relaxed) != 0) {
    throw Error(Fault::interrupted, "interrupted");
  }
}

}  // namespace polhode
