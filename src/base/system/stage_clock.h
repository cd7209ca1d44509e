// SPDX-License-Identifier: MIT
// Measures wall time and processor time of the stages of a run, for the report of a film.
#pragma once

#include <chrono>
#include <ctime>
#include <map>
#include <set>

namespace polhode {

// Time spent in one stage. If other threads work for it, such as those of an encoder, the owner of
// the stage adds their processor time, measured with ThreadClocks.
struct StageTime {
  double wall_s = 0.0;  // s
  double cpu_s = 0.0;   // s; of the thread that ran the stage, plus those that its owner adds

  StageTime& operator+=(const StageTime& more) {
    wall_s += more.wall_s;
    cpu_s += more.cpu_s;
    return *this;
  }
};

// Adds the time between its construction and its destruction, which must be on the same thread, to
// a StageTime.
class StageTimer {
 public:
  // `stage` must outlive the timer.
  explicit StageTimer(StageTime& stage)
      : stage_(stage), wall_(Clock::now()), cpu_(thread_cpu_seconds()) {}
  ~StageTimer() {
    stage_.wall_s += std::chrono::duration<double>(Clock::now() - wall_).count();
    stage_.cpu_s += thread_cpu_seconds() - cpu_;
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  static double thread_cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  StageTime& stage_;
  Clock::time_point wall_;
  double cpu_;
};

// The ids (Linux tid) of the threads of this process; empty without /proc. The ids that appear
// during a library call are the threads that it started (rasteriser, encoder).
std::set<int> thread_ids();

// Measures the processor time of a set of threads of this process, also of threads that end before
// the last reading. Not thread-safe.
class ThreadClocks {
 public:
  // `threads`: ids as from thread_ids().
  explicit ThreadClocks(const std::set<int>& threads);
  // Reads the clocks of the threads that still run, since their start; those that have ended keep
  // their last reading.
  void read();
  // Processor time in seconds, summed over all threads at their last readings; 0 before read().
  double total() const;

 private:
  std::map<int, double> seconds_;
};

}  // namespace polhode
