// SPDX-License-Identifier: MIT
#include "batch/task_states.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <sstream>
#include <thread>

#include <fmt/format.h>

#include "base/error.h"
#include "base/one_line.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "base/system/interrupt.h"
#include "batch/slurm.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;
using Kind = SlurmState::Kind;

// What explains a failure best: Slurm's last words since the task last began, else the program's,
// which only says that it was interrupted if Slurm ended it.
std::string telling_line(const fs::path& log) {
  std::string text;
  try {
    text = read_file(log);
  } catch (const Error&) {
    return "no log";
  }
  std::istringstream lines(text);
  std::string last, said, slurm;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("task ") && line.find(" on ") != std::string::npos) {
      last.clear();
      said.clear();
      slurm.clear();
      continue;
    }
    if (line.empty()) continue;
    last = line;
    if (line.starts_with("polhode: ")) said = line;
    if (line.starts_with("slurmstepd")) slurm = line;
  }
  if (!slurm.empty()) said = slurm;
  if (said.empty()) said = last;
  return said.empty() ? "its log says nothing" : one_line(said.substr(0, 500));
}

std::string code_in(const fs::path& mark) {
  std::string text;
  try {
    text = read_file(mark, 100);
  } catch (const Error&) {
    return "";
  }
  return one_line(text.substr(0, text.find('\n')));
}

TaskState failure(const SlurmState* slurm, const fs::path& mark, const fs::path& log) {
  std::string how;
  if (slurm != nullptr && slurm->kind == Kind::ended_badly && slurm->words != "FAILED")
    how = slurm->words;
  const std::string code = code_in(mark);
  if (!code.empty()) how += fmt::format("{}exit code {}", how.empty() ? "" : ", ", code);
  if (how.empty()) how = "killed";
  return {TaskProgress::failed, fmt::format("{}: {}", how, telling_line(log))};
}

// of a task that is not done; slurm: null if it knows nothing
TaskState unfinished(const SlurmState* slurm,
                     bool queued,
                     const fs::path& mark,
                     const fs::path& log) {
  if (slurm != nullptr && slurm->kind == Kind::waiting) return {TaskProgress::waiting, ""};
  if (slurm != nullptr && slurm->kind == Kind::running) return {TaskProgress::running, ""};
  if (is_there(mark)) return failure(slurm, mark, log);
  // its mark is on its way
  if (slurm != nullptr && slurm->kind == Kind::ended_well) return {TaskProgress::running, ""};
  if (slurm != nullptr || (queued && is_there(log))) return failure(slurm, mark, log);
  return {};
}

const SlurmState* find_state(const std::map<int, SlurmState>& states, int task) {
  const auto found = states.find(task);
  return found == states.end() ? nullptr : &found->second;
}

}  // namespace

int JobState::count(TaskProgress progress) const {
  return static_cast<int>(std::count_if(tasks.begin(), tasks.end(), [&](const TaskState& task) {
    return task.progress == progress;
  }));
}

bool JobState::is_active() const {
  const auto active = [](const TaskState& task) {
    return task.progress == TaskProgress::running || task.progress == TaskProgress::waiting;
  };
  return active(collecting) || std::any_of(tasks.begin(), tasks.end(), active);
}

JobState state_of_job(const fs::path& folder, const BatchJob& job) {
  JobState state;
  state.tasks.resize(static_cast<std::size_t>(job.tasks));
  state.made = is_made(folder, job);
  if (state.made) {
    std::fill(state.tasks.begin(), state.tasks.end(), TaskState{TaskProgress::done, ""});
    state.collecting.progress = TaskProgress::done;
    return state;
  }
  state.lost = is_there(folder / "state/collected");
  if (state.lost) return state;
  // a task that was queued again is as its last submission says
  std::map<int, SlurmState> known;
  std::vector<bool> queued(state.tasks.size() + 1);
  for (const Submission& one : job.submissions) {
    const std::map<int, SlurmState> states = states_in_slurm(one.array);
    for (const int task : one.tasks) {
      if (task < 1 || task > job.tasks) continue;
      queued[static_cast<std::size_t>(task)] = true;
      known.erase(task);
      if (const SlurmState* found = find_state(states, task)) known[task] = *found;
    }
  }
  std::fill(state.tasks.begin(), state.tasks.end(), TaskState{TaskProgress::done, ""});
  for (const int task : missing_tasks(folder, job)) {
    state.tasks[static_cast<std::size_t>(task) - 1] =
        unfinished(find_state(known, task),
                   queued[static_cast<std::size_t>(task)],
                   mark_of_task(folder, task, "failed"),
                   log_of_task(folder, task));
  }
  if (!job.submissions.empty()) {
    const std::map<int, SlurmState> states = states_in_slurm(job.submissions.back().collecting);
    const fs::path log = folder / "logs/collect.log";
    state.collecting =
        unfinished(find_state(states, 0), is_there(log), folder / "state/collect.failed", log);
  }
  return state;
}

std::string words_of_state(const fs::path& folder, const BatchJob& job, const JobState& state) {
  const auto shown = [](const fs::path& path) {
    return one_line(path.string());
  };
  if (state.lost) {
    return fmt::format("{} was made, and is not there any more; submit it again\n",
                       shown(job.output));
  }
  std::string text = fmt::format(
      "{}: {} of {} tasks done", shown(job.output), state.count(TaskProgress::done), job.tasks);
  const auto add = [&](TaskProgress progress, const char* word) {
    if (const int count = state.count(progress); count > 0)
      text += fmt::format(", {} {}", count, word);
  };
  add(TaskProgress::running, "running");
  add(TaskProgress::waiting, "waiting");
  add(TaskProgress::failed, "failed");
  add(TaskProgress::not_begun, "not begun");
  switch (state.collecting.progress) {
    case TaskProgress::done:
      text += "; collected";
      break;
    case TaskProgress::running:
      text += "; being collected";
      break;
    case TaskProgress::waiting:
      text += "; to be collected";
      break;
    case TaskProgress::failed:
    case TaskProgress::not_begun:
      text += "; not collected";
      break;
  }
  text += '\n';
  for (int task = 1; task <= job.tasks; ++task) {
    const TaskState& one = state.tasks[static_cast<std::size_t>(task) - 1];
    if (one.progress == TaskProgress::failed)
      text += fmt::format("task {}: {} ({})\n", task, one.why, shown(log_of_task(folder, task)));
  }
  if (state.collecting.progress == TaskProgress::failed) {
    text += fmt::format(
        "collecting: {} ({})\n", state.collecting.why, shown(folder / "logs/collect.log"));
  }
  return text;
}

int exit_code_of(const JobState& state) {
  const bool failed =
      state.count(TaskProgress::failed) > 0 || state.collecting.progress == TaskProgress::failed;
  return failed ? static_cast<int>(Fault::check_failed) : 0;
}

JobState settled_state(const fs::path& folder, const BatchJob& job) {
  using Clock = std::chrono::steady_clock;
  constexpr auto kLatest = std::chrono::seconds(60);  // what clients of NFS keep of a folder
  const Clock::time_point start = Clock::now();
  while (true) {
    JobState state = state_of_job(folder, job);
    if (!(state.count(TaskProgress::running) > 0 && Clock::now() - start < kLatest)) return state;
    stop_if_interrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

}  // namespace polhode
