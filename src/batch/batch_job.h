// SPDX-License-Identifier: MIT
// A job that `submit` has divided into tasks, as its folder remembers it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

// How many tasks a job may have.
inline constexpr int kMostTasks = 100'000;

// The folder of the job that makes an output: maps.job beside the folder maps. It holds job.json,
// the scripts tasks.sh and collect.sh, logs/task-K.log and logs/collect.log, and state/, where the
// scripts leave K.done or K.failed (with the exit code) for each task, and collected or
// collect.failed. An absolute path.
std::filesystem::path job_folder_of(const std::filesystem::path& output);

// One call of `submit` that has queued something.
struct Submission {
  std::string array;       // number of the Slurm job; empty: no task was missing
  std::string collecting;  // that of the job that collects
  std::vector<int> tasks;  // which tasks were queued, from 1
};

// What is to be done, and what has been queued.
struct BatchJob {
  std::string hash;                     // hash_of_work() (app/piecewise.h)
  std::string command;                  // "render"
  std::vector<std::string> options;     // of the command, that every run needs
  std::vector<std::string> arguments;   // what the user wrote after the command
  std::string program;                  // absolute path
  std::string working_folder;           // absolute path
  std::string output;                   // absolute path
  std::vector<std::string> proof;       // see DividedWork
  bool has_jobs = true, alone = false;  // see DividedWork
  std::string things;                   // "rows"
  long pieces = 1;
  int tasks = 1;
  double longest_s = 0.0;  // s, expected length of a task
  std::vector<Submission> submissions;
};

// Reads and writes FOLDER/job.json. Throws Error (input), with the file as place, for a file that
// is not one of these, and as read_file and write_file (base/system/atomic_file.h) do. Text must be
// UTF-8; write_job() throws Error (input) for other names.
BatchJob read_job(const std::filesystem::path& folder);
void write_job(const std::filesystem::path& folder, const BatchJob& job);

// The folder that the user means: itself, or that of the output of that name. Throws Error (input)
// if neither is the folder of a job.
std::filesystem::path find_job(const std::filesystem::path& named);

// Whether the product is there: collected, and not deleted since.
bool is_made(const std::filesystem::path& folder, const BatchJob& job);

// Files of the folder.
std::filesystem::path mark_of_task(const std::filesystem::path& folder, int task, const char* what);
std::filesystem::path log_of_task(const std::filesystem::path& folder, int task);

// The tasks from 1 that are not done yet.
std::vector<int> missing_tasks(const std::filesystem::path& folder, const BatchJob& job);

// "1-3,7" for 1, 2, 3, 7, as `sbatch --array` reads it.
std::string ranges_of(const std::vector<int>& numbers);
// The reverse; what is no number, or more than kMostTasks, is left out.
std::vector<int> numbers_in(const std::string& ranges);

}  // namespace polhode
