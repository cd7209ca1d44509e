// SPDX-License-Identifier: MIT
// Wall and processor time of the stages of a run, for the report.
#pragma once

#include <chrono>
#include <ctime>
#include <map>
#include <set>

namespace polhode {

// Time spent in one stage. cpu counts the thread that ran it, plus helper threads added later.
struct StageTime {
  double wall_s = 0.0;
  double cpu_s = 0.0;
};

// Adds the time of its own scope to a StageTime.
class StageTimer {
 public:
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

// The ids of the threads this process has now. What a library call starts (rasteriser, encoder) is
// the difference of the sets before and after it.
std::set<int> thread_ids();

// The processor clocks of threads that may end before their last reading.
class ThreadClocks {
 public:
  explicit ThreadClocks(const std::set<int>& threads);
  // Reads the clocks of those that still live.
  void read();
  // Processor seconds, of each thread at its last reading.
  double total() const;

 private:
  std::map<int, double> seconds_;
};

}  // namespace polhode
