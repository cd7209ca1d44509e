// SPDX-License-Identifier: MIT
// The scripts that Slurm runs: one for each task, one that collects.
#pragma once

#include <string>
#include <vector>

#include "batch/batch_job.h"

namespace polhode {

// What is passed on to Slurm. Absent: what the cluster does by itself.
struct SlurmOptions {
  std::string partition, time, memory, account;  // of sbatch
  std::string more;                              // further options of sbatch, as one line
  int at_once = 0;                               // most tasks that run at once; 0: no limit
};

// Throws Error (input), with the option as key, for a value that is not one word or, of `more`, not
// one line.
void check_slurm_options(const SlurmOptions& options);

// The scripts of a job in a folder, for sh. They need no file but the program and what the command
// itself reads.
std::string task_script(const BatchJob& job,
                        const std::filesystem::path& folder,
                        const SlurmOptions& options);
std::string collecting_script(const BatchJob& job,
                              const std::filesystem::path& folder,
                              const SlurmOptions& options);

// The calls of sbatch: for these tasks (not empty), and for the job that collects once the job
// `after` has ended, however it did; empty: at once.
std::vector<std::string> call_for_tasks(const std::filesystem::path& folder,
                                        const std::vector<int>& tasks,
                                        const SlurmOptions& options);
std::vector<std::string> call_for_collecting(const std::filesystem::path& folder,
                                             const std::string& after);

// The words as one line that a shell takes apart again.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace polhode
