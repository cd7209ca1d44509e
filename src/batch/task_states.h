// SPDX-License-Identifier: MIT
// How far the tasks of a job are, from the marks in its folder, its logs, and what Slurm knows.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "batch/batch_job.h"

namespace polhode {

enum class TaskProgress {
  done,
  running,
  waiting,    // queued
  failed,     // it ended without a result
  not_begun,  // not queued, or nobody knows
};

struct TaskState {
  TaskProgress progress = TaskProgress::not_begun;
  std::string why;  // of a failed task: a line of its log, behind what Slurm says
};

struct JobState {
  std::vector<TaskState> tasks;  // of task 1, 2, …
  TaskState collecting;
  bool made = false;  // the product is there
  bool lost = false;  // it was collected, and is not there any more

  int count(TaskProgress progress) const;
  // Whether anything is queued or running.
  bool is_active() const;
};

// Looks once. Throws Error as is_there() (base/system/files.h) does; (environment) if Slurm cannot
// be asked about what is missing; (interrupted).
JobState state_of_job(const std::filesystem::path& folder, const BatchJob& job);

// The state for people: a line of counts, one for the collecting job, one for each failure.
std::string words_of_state(const std::filesystem::path& folder,
                           const BatchJob& job,
                           const JobState& state);

// The exit code of `status`: 1 if a task or the collecting job has failed, else 0.
int exit_code_of(const JobState& state);

// Looks until all tasks are done, have failed, or a minute has passed in which those that Slurm
// calls complete have not appeared: shared folders may be late. For the collecting job.
JobState settled_state(const std::filesystem::path& folder, const BatchJob& job);

}  // namespace polhode
