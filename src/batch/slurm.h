// SPDX-License-Identifier: MIT
// Slurm's own programs. Only this unit runs them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/system/progress.h"

namespace polhode {

// What Slurm says of a task or job.
struct SlurmState {
  enum class Kind { waiting, running, ended_well, ended_badly };
  Kind kind = Kind::waiting;
  std::string words;  // of Slurm: "PENDING", "TIMEOUT", "NODE_FAIL"
};

// Throws Error (environment), saying what to install and what can be done without it, if sbatch is
// not here.
void require_slurm();
// Whether Slurm can be asked here.
bool has_slurm();

// Queues a job by that call of sbatch with --parsable, and returns its number. Throws Error
// (environment), with the words of sbatch, if it refuses. `kind`: how it is shown that sbatch
// waits.
std::string submit_to_slurm(const std::vector<std::string>& call, ProgressKind kind);

// The states of the tasks of an array, by their numbers, and of a job that is none as number 0. It
// is empty without Slurm, and what ended some minutes ago is missing: Slurm forgets. Throws Error
// (environment) if Slurm cannot be asked or gives no answer; (interrupted).
std::map<int, SlurmState> states_in_slurm(const std::string& job);

// Takes back what of these jobs is not over. Returns nothing, or why that failed, in words of
// scancel. Throws Error (interrupted).
std::optional<std::string> cancel_in_slurm(const std::vector<std::string>& jobs);

}  // namespace polhode
