// SPDX-License-Identifier: MIT
// What `status` and `cancel` read of work on a cluster: job.json, and ranges of tasks as Slurm
// writes them.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/error.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "batch/batch_job.h"
#include "batch/task_states.h"
#include "fuzz/harness.h"

namespace polhode {
namespace {

// one for the whole process
const std::filesystem::path& job_folder() {
  static const std::filesystem::path folder = [] {
    std::string name = "/tmp/fuzz_job_XXXXXX";
    promise(mkdtemp(name.data()) != nullptr, "a folder");
    make_folder(std::filesystem::path(name) / "state");
    std::atexit([] { std::filesystem::remove_all(job_folder()); });
    return std::filesystem::path(name);
  }();
  return folder;
}

void read_ranges(const std::string& text) {
  std::vector<int> numbers = numbers_in(text);
  for (const int number : numbers)
    promise(number >= 0, "tasks have numbers");
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  promise(numbers_in(ranges_of(numbers)) == numbers, "ranges are read as they were written");
}

}  // namespace

void run_harness(const std::string& bytes) {
  constexpr std::size_t kRanges = 60;
  if (!bytes.starts_with('{')) {
    if (bytes.size() < kRanges) read_ranges(bytes);
    return;
  }
  write_file(job_folder() / "job.json", bytes);
  const BatchJob job = read_job(job_folder());
  promise(job.tasks >= 1 && job.pieces >= 1, "a job has tasks and pieces");
  constexpr int kShown = 1000;
  if (job.tasks <= kShown) {
    JobState state;
    state.tasks.resize(static_cast<std::size_t>(job.tasks));
    for (const int task : missing_tasks(job_folder(), job))
      state.tasks[static_cast<std::size_t>(task) - 1].progress = TaskProgress::failed;
    promise(words_of_state(job_folder(), job, state).ends_with('\n'), "a state is told in lines");
  }
  write_job(job_folder(), job);
  const BatchJob again = read_job(job_folder());
  promise(again.arguments == job.arguments && again.tasks == job.tasks &&
              again.output == job.output && again.pieces == job.pieces,
          "a job that is written and read is the same");
}

}  // namespace polhode
