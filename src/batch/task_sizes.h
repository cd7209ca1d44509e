// SPDX-License-Identifier: MIT
// Into how many tasks work is divided, and how long it will take.
#pragma once

#include "app/divided_work.h"

namespace polhode {

// The shortest task, s: schedulers ask for more, and nobody waits for less.
inline constexpr double kShortestTask = 30.0;
// The largest share of a task that its start may take.
inline constexpr double kMostOfStart = 0.05;

// Tasks of about equal length.
struct TaskSizes {
  int tasks = 1;
  double longest_s = 0.0;  // s, of the task with the most pieces, with its start
  double start_s = 0.0;    // s, of it
};

// As many tasks as there is work for: none shorter than kShortestTask or so short that its start
// takes more than kMostOfStart, none without a piece, at most `most`. If there are fewer pieces to
// a task than that, all tasks have equally many but the last.
TaskSizes sizes_of_tasks(const DividedWork& work, int most);

// The same for a given number of tasks.
TaskSizes sizes_of_tasks(const DividedWork& work, double start_s, int tasks);

// How long the tasks take on that many processors or nodes, each of which runs one at a time, s.
double wall_seconds(const TaskSizes& sizes, int at_once);

}  // namespace polhode
