// SPDX-License-Identifier: MIT
#include "base/interrupt.h"

#include <atomic>
#include <csignal>

#include "base/error.h"

namespace polhode {
namespace {

// the one global besides the logger: a signal handler has nothing else to write to
std::atomic<int> signal_seen{0};

extern "C" void remember_signal(int signal) {
  signal_seen.store(signal, std::memory_order_relaxed);
  // a second signal ends the process at once
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_for_interrupt() {
  static_assert(std::atomic<int>::is_always_lock_free);
  std::signal(SIGINT, remember_signal);
  std::signal(SIGTERM, remember_signal);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void stop_if_interrupted() {
  if (signal_seen.load(std::memory_order_relaxed) != 0) {
    throw Error(Fault::interrupted, "interrupted; nothing was written");
  }
}

}  // namespace polhode
