// SPDX-License-Identifier: MIT
#include "batch/slurm.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"
#include "base/one_line.h"
#include "base/system/child_process.h"
#include "batch/batch_job.h"

namespace polhode {
namespace {

constexpr std::array<std::string_view, 7> kWaiting = {"PENDING",
                                                      "REQUEUED",
                                                      "REQUEUE_HOLD",
                                                      "REQUEUE_FED",
                                                      "RESV_DEL_HOLD",
                                                      "SPECIAL_EXIT",
                                                      "EXPEDITING"};
constexpr std::array<std::string_view, 10> kEndedBadly = {"CANCELLED",
                                                          "FAILED",
                                                          "TIMEOUT",
                                                          "NODE_FAIL",
                                                          "PREEMPTED",
                                                          "BOOT_FAIL",
                                                          "DEADLINE",
                                                          "OUT_OF_MEMORY",
                                                          "LAUNCH_FAILED",
                                                          "REVOKED"};

template <class Names>
bool is_in(const Names& names, std::string_view word) {
  return std::find(names.begin(), names.end(), word) != names.end();
}

SlurmState state_of(const std::string& word) {
  using Kind = SlurmState::Kind;
  if (word == "COMPLETED") return {Kind::ended_well, word};
  if (is_in(kWaiting, word)) return {Kind::waiting, word};
  if (is_in(kEndedBadly, word)) return {Kind::ended_badly, word};
  // the others, as COMPLETING, and those of a later Slurm: it forgets a job soon after its end
  return {Kind::running, word};
}

// the value of NAME=value in a line of scontrol; empty: it is not there
std::string value_in(const std::string& line, const std::string& name) {
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    if (word.starts_with(name + "=")) return word.substr(name.size() + 1);
  }
  return "";
}

// whether Slurm knows no such job, as it is some minutes after its end
bool has_forgotten(const ChildResult& result) {
  return result.err.find("Invalid job id") != std::string::npos;
}

}  // namespace

bool has_slurm() {
  return find_program("scontrol").installed;
}

void require_slurm() {
  if (find_program("sbatch").installed) return;
  throw environment_error(
      "sbatch is not installed: this is no machine of a Slurm cluster (Debian: slurm-client); "
      "--dry-run shows the scripts, and docs/cluster.md how to do the same without Slurm");
}

std::string submit_to_slurm(const std::vector<std::string>& call, ProgressKind kind) {
  Waiting waiting(kind);
  const ChildResult result =
      run_child(call, "", {120.0}, [&] { waiting.show("waiting for Slurm to take the job"); });
  if (!ended_well(result)) throw environment_error("sbatch {}", how_it_ended(result));
  // "123" or "123;cluster"
  const std::string answer = result.out.substr(0, result.out.find('\n'));
  std::string number = answer.substr(0, answer.find(';'));
  constexpr std::size_t kMostDigits = 10;
  const bool is_number = !number.empty() && number.size() <= kMostDigits && number[0] != '0' &&
                         number.find_first_not_of("0123456789") == std::string::npos;
  if (!is_number || answer.find(' ') != std::string::npos) {
    throw environment_error("sbatch answered '{}' instead of the number of a job",
                            one_line(result.out.substr(0, 80)));
  }
  return number;
}

std::map<int, SlurmState> states_in_slurm(const std::string& job) {
  std::map<int, SlurmState> states;
  if (job.empty() || !has_slurm()) return states;
  const ChildResult result = run_child({"scontrol", "--oneliner", "show", "job", job}, "", {60.0});
  if (!ended_well(result)) {
    if (has_forgotten(result)) return states;
    throw environment_error("Slurm does not say how job {} is: scontrol {}; ask again later",
                            job,
                            how_it_ended(result));
  }
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) {
    const std::string word = value_in(line, "JobState");
    if (word.empty()) continue;
    const std::string tasks = value_in(line, "ArrayTaskId");
    for (const int task : tasks.empty() ? std::vector<int>{0} : numbers_in(tasks))
      states[task] = state_of(word);
  }
  if (states.empty()) {
    throw environment_error("Slurm does not say how job {} is: scontrol answered '{}'",
                            job,
                            one_line(result.out.substr(0, 80)));
  }
  return states;
}

std::optional<std::string> cancel_in_slurm(const std::vector<std::string>& jobs) {
  if (jobs.empty()) return {};
  std::vector<std::string> call = {"scancel"};
  call.insert(call.end(), jobs.begin(), jobs.end());
  const ChildResult result = run_child(call, "", {60.0});
  if (ended_well(result)) return {};
  return "scancel " + how_it_ended(result);
}

}  // namespace polhode
