// SPDX-License-Identifier: MIT
#include "batch/task_sizes.h"

#include <algorithm>
#include <cmath>

namespace polhode {

TaskSizes sizes_of_tasks(const DividedWork& work, double start_s, int tasks) {
  const long most = (work.pieces + tasks - 1) / tasks;
  return {tasks, start_s + static_cast<double>(most) * work.piece_s, start_s};
}

TaskSizes sizes_of_tasks(const DividedWork& work, int most) {
  const double all = work.piece_s * static_cast<double>(work.pieces);
  const double shortest = std::max(kShortestTask, work.start_s / kMostOfStart);
  const double wanted = std::floor(all / shortest);
  const auto upper = static_cast<double>(std::min<long>(most, work.pieces));
  const auto tasks = static_cast<long>(std::clamp(wanted, 1.0, upper));
  // with the same number of pieces in the longest, fewer may do
  const long each = (work.pieces + tasks - 1) / tasks;
  return sizes_of_tasks(work, work.start_s, static_cast<int>((work.pieces + each - 1) / each));
}

double wall_seconds(const TaskSizes& sizes, int at_once) {
  return std::ceil(static_cast<double>(sizes.tasks) / at_once) * sizes.longest_s;
}

}  // namespace polhode
