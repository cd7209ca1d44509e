// SPDX-License-Identifier: MIT
// Divides work into tasks and hands them to Slurm; waits for them; takes them back.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/divided_work.h"
#include "base/system/progress.h"
#include "batch/batch_scripts.h"

namespace polhode {

// The options of `submit`.
struct SubmitJob {
  std::string command;                 // what is divided: "render"
  std::vector<std::string> arguments;  // its words
  SlurmOptions slurm;
  int most_tasks = 1000;  // the usual MaxArraySize of Slurm allows that many
  int tasks = 0;          // exactly so many; 0: by their cost
  bool dry_run = false;   // queue nothing, write nothing, return the scripts
  bool wait = false;      // until the product is there
  ProgressKind progress = ProgressKind::automatic;
};

// What the command prints and returns.
struct SubmitResult {
  std::string text;
  int code = 0;  // 1: it waited, and something failed
};

// Queues the tasks of the work that are not done, and the job that collects them. A job that is
// queued already is left alone, one whose product is there too; the folder of a job that is not
// queued and was of other work (the scene has changed) is begun again. Only one submit works on a
// folder at a time. Throws Error (input) for wrong options, while other work is queued for the same
// output, and if another submit is at work; (environment) without Slurm or if it refuses, and as
// write_job() (batch/batch_job.h) does; (interrupted), after which the jobs go on.
SubmitResult submit(const SubmitJob& job, const DividedWork& work);

// Takes all queued and running tasks of a job back, and says so. Throws Error (environment) without
// Slurm or if it refuses.
std::string cancel(const std::filesystem::path& folder);

}  // namespace polhode
