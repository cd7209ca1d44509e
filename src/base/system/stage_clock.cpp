// SPDX-License-Identifier: MIT
#include "base/system/stage_clock.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace polhode {

std::set<int> thread_ids() {
  std::set<int> ids;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", failed)) {
    ids.insert(std::stoi(entry.path().filename().string()));
  }
  return ids;
}

ThreadClocks::ThreadClocks(const std::set<int>& threads) {
  for (const int id : threads)
    seconds_[id] = 0.0;
}

void ThreadClocks::read() {
  for (auto& [id, seconds] : seconds_) {
    // first number of schedstat: time on a processor in nanoseconds
    std::ifstream file("/proc/self/task/" + std::to_string(id) + "/schedstat");
    double nanoseconds = 0.0;
    if (file >> nanoseconds) seconds = 1e-9 * nanoseconds;
  }
}

double ThreadClocks::total() const {
  double total = 0.0;
  for (const auto& [id, seconds] : seconds_)
    total += seconds;
  return total;
}

}  // namespace polhode
