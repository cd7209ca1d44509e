// SPDX-License-Identifier: MIT
#include "base/system/interrupt.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>

#include "base/error.h"

namespace polhode {
namespace {

// the one global besides the logger: a signal handler has nothing else to write to
std::atomic<std::int64_t> first_signal_ms{0};  // when it came; 0: none has

// One word from a user often comes as two signals: from the terminal and from its shell.
constexpr std::int64_t kPatienceMs = 500;

// the clock may be read in a handler; never 0
std::int64_t now_ms() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000 + 1;
}

extern "C" void remember_signal(int signal) {
  std::int64_t first = 0;
  const std::int64_t now = now_ms();
  if (first_signal_ms.compare_exchange_strong(first, now)) return;
  // a user who asks again wants the end at once
  if (now - first < kPatienceMs) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void watch_for_interrupt() {
  static_assert(std::atomic<std::int64_t>::is_always_lock_free);
  std::signal(SIGINT, remember_signal);
  std::signal(SIGTERM, remember_signal);
  std::signal(SIGHUP, remember_signal);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void stop_if_interrupted() {
  if (first_signal_ms.load(std::memory_order_relaxed) != 0) {
    throw Error(Fault::interrupted, "interrupted; nothing was written");
  }
}

}  // namespace polhode
