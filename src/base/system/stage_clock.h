// SPDX-License-Identifier: MIT
// Measures wall time and processor time of the stages of a run, for the report.
#pragma once

#include <chrono>
#include <ctime>
#include <map>
#include <set>

namespace polhode {

// Time spent in one stage, in seconds. cpu_s covers the thread that ran the stage, plus helper
// threads that are added later.
struct StageTime {
  double wall_s = 0.0;
  double cpu_s = 0.0;
};

// Adds the time between its construction and destruction, on one thread, to a StageTime.
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

// The ids of the threads of this process. The difference between the sets before and after a
// library call is the threads that it started (rasteriser, encoder).
std::set<int> thread_ids();

// Processor time of threads that may end before the last reading.
class ThreadClocks {
 public:
  explicit ThreadClocks(const std::set<int>& threads);
  // Reads the clocks of the threads that are still running.
  void read();
  // Processor seconds, summed over all threads, each at its last reading.
  double total() const;

 private:
  std::map<int, double> seconds_;
};

}  // namespace polhode
