// SPDX-License-Identifier: MIT
#include "batch/submit.h"

#include <chrono>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "app/piecewise.h"
#include "base/error.h"
#include "base/one_line.h"
#include "base/shell_word.h"
#include "base/system/atomic_file.h"
#include "base/system/child_process.h"
#include "base/system/files.h"
#include "base/system/interrupt.h"
#include "batch/slurm.h"
#include "batch/task_sizes.h"
#include "batch/task_states.h"
#include "film/output/resumed_film.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

// "7 s", "12 min", "3.5 h"
std::string duration(double seconds) {
  if (seconds < 99.5) return fmt::format("{:.0f} s", std::max(1.0, seconds));
  if (seconds < 99.5 * 60) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string own_program() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  if (failed) throw environment_error("the program cannot be found: there is no /proc/self/exe");
  return program.string();
}

BatchJob batch_job_of(const SubmitJob& job, const DividedWork& work, const TaskSizes& sizes) {
  BatchJob batch;
  batch.hash = hash_of_work(work.words);
  batch.command = job.command;
  batch.options = work.options;
  batch.arguments = job.arguments;
  batch.program = own_program();
  batch.working_folder = working_folder().string();
  batch.output = absolute_path(work.output).string();
  batch.proof = work.proof;
  batch.has_jobs = work.has_jobs;
  batch.alone = work.alone;
  batch.things = work.things;
  batch.pieces = work.pieces;
  batch.tasks = sizes.tasks;
  batch.longest_s = sizes.longest_s;
  return batch;
}

// how long it will take, by the number of tasks that run at once
std::string expectation(const BatchJob& batch, const TaskSizes& sizes) {
  std::string text = fmt::format("{} {} in {} task{} of about {}, {} of it to start\n",
                                 batch.pieces,
                                 batch.things,
                                 sizes.tasks,
                                 sizes.tasks == 1 ? "" : "s",
                                 duration(sizes.longest_s),
                                 duration(sizes.start_s));
  const auto line = [&](int at_once) {
    return fmt::format("  on {:>4} node{} {}\n",
                       at_once,
                       at_once == 1 ? ": " : "s:",
                       duration(wall_seconds(sizes, at_once)));
  };
  int at_once = 1;
  for (; at_once < sizes.tasks; at_once *= 2)
    text += line(at_once);
  return text + line(sizes.tasks);
}

std::string dry_run(const BatchJob& batch,
                    const fs::path& folder,
                    const SlurmOptions& slurm,
                    const TaskSizes& sizes,
                    const std::vector<int>& missing) {
  std::string text = fmt::format("# {}\n{}\n# {}\n{}\n",
                                 one_line((folder / "tasks.sh").string()),
                                 task_script(batch, folder, slurm),
                                 one_line((folder / "collect.sh").string()),
                                 collecting_script(batch, folder, slurm));
  if (!missing.empty()) text += shell_line(call_for_tasks(folder, missing, slurm)) + "\n";
  text += shell_line(call_for_collecting(folder, missing.empty() ? "" : "JOB")) + "\n\n";
  return text + expectation(batch, sizes);
}

// What stands in the folder; nothing if there is none.
std::optional<BatchJob> earlier_job(const fs::path& folder) {
  if (!is_there(folder / "job.json")) return {};
  return read_job(folder);
}

// the numbers of what is queued
std::string numbers_of(const BatchJob& job) {
  const Submission& last = job.submissions.back();
  if (last.array.empty()) return last.collecting;
  return fmt::format("{} and {}", last.array, last.collecting);
}

// Films are made in pieces beside them, and those of another film would stop the tasks.
void refuse_other_pieces(const BatchJob& batch) {
  const std::string pieces = folder_of_pieces(batch.output);
  if (!is_there(pieces)) return;
  throw input_error("holds pieces of the film as it was before; delete it and submit again")
      .at({pieces, 0, {}});
}

// A job of other work gives way unless it is queued. One of the same work goes on as it was
// divided.
BatchJob settle(const fs::path& folder, BatchJob batch, bool& is_active, bool changes_files) {
  is_active = false;
  std::optional<BatchJob> earlier = earlier_job(folder);
  if (!earlier) return batch;
  const bool same = earlier->hash == batch.hash;
  const JobState state = state_of_job(folder, *earlier);
  is_active = state.is_active();
  if (!same && is_active) {
    throw input_error(
        "other work is queued for this output (Slurm job {}): the scene, an option or the program "
        "was "
        "different; wait for it, or take it back with polhode cancel {}",
        numbers_of(*earlier),
        shell_word(folder.string()))
        .at({folder.string(), 0, {}});
  }
  if (!same) refuse_other_pieces(batch);
  if (!same || state.lost) {
    if (changes_files) {
      remove_file(folder / "state");
      remove_file(folder / "logs");
    }
    return batch;
  }
  // the division holds, and so do the paths that the user names now
  batch.options = earlier->options;
  batch.pieces = earlier->pieces;
  batch.tasks = earlier->tasks;
  batch.longest_s = earlier->longest_s;
  batch.submissions = earlier->submissions;
  return batch;
}

// Takes a job back; returns nothing, or why that failed.
std::optional<std::string> why_not_cancelled(const std::string& number) {
  try {
    return cancel_in_slurm({number});
  } catch (const Error& error) {
    return error.message();
  }
}

void queue(BatchJob& batch,
           const fs::path& folder,
           const SubmitJob& job,
           const std::vector<int>& missing) {
  Submission now;
  now.tasks = missing;
  if (!missing.empty()) {
    const auto call = call_for_tasks(folder, missing, job.slurm);
    now.array = submit_to_slurm(call, job.progress);
  }
  try {
    now.collecting = submit_to_slurm(call_for_collecting(folder, now.array), job.progress);
    batch.submissions.push_back(now);
    write_job(folder, batch);
  } catch (const Error& error) {
    // nothing is left in the queue that nobody knows of
    std::string told = error.message();
    for (const std::string& number : {now.array, now.collecting}) {
      if (number.empty()) continue;
      const std::optional<std::string> why = why_not_cancelled(number);
      if (!why) continue;
      told += fmt::format(
          "; job {0} is still queued and has no work: take it back by scancel {0} ({1})",
          number,
          *why);
    }
    throw Error(error.fault(), told, error.place());
  }
}

// The folder may be one that somebody else made.
void refuse_foreign_scripts(const fs::path& folder) {
  constexpr std::size_t kHead = 4096;  // bytes; long options stand before the words
  for (const char* name : {"tasks.sh", "collect.sh"}) {
    const fs::path script = folder / name;
    if (!is_there(script)) continue;
    if (head_of_file(script, kHead).find("# Written by polhode") == std::string::npos) {
      throw input_error("was not written by `polhode submit`; move it or choose another output")
          .at({script.string(), 0, {}});
    }
  }
}

// Queues what is neither done nor queued, and says what it did; `batch` becomes what is queued now.
std::string queue_missing(const SubmitJob& job,
                          const fs::path& folder,
                          const DividedWork& measured,
                          BatchJob& batch) {
  const AtomicFile lock(folder / "submit");
  bool is_active = false;
  batch = settle(folder, batch, is_active, true);
  if (is_made(folder, batch) && !batch.submissions.empty())
    return fmt::format("{} is there; delete it to make it again\n", one_line(batch.output));
  if (is_active) return fmt::format("already submitted as Slurm job {}\n", numbers_of(batch));

  refuse_foreign_scripts(folder);
  make_folder(folder / "state");
  make_folder(folder / "logs");
  for (const char* mark : {"state/collected", "state/collect.failed"})
    remove_file(folder / mark);
  const std::vector<int> missing = missing_tasks(folder, batch);
  for (const int task : missing)
    remove_file(mark_of_task(folder, task, "failed"));
  write_file(folder / "tasks.sh", task_script(batch, folder, job.slurm));
  write_file(folder / "collect.sh", collecting_script(batch, folder, job.slurm));
  queue(batch, folder, job, missing);
  return fmt::format("{} of {} tasks of about {} submitted as Slurm job {}\n",
                     missing.size(),
                     batch.tasks,
                     duration(sizes_of_tasks(measured, measured.start_s, batch.tasks).longest_s),
                     numbers_of(batch));
}

// One bar for all tasks, from the marks in the folder; Slurm is asked now and then.
int wait_for(const fs::path& folder, const BatchJob& batch, ProgressKind kind, std::string& text) {
  using Clock = std::chrono::steady_clock;
  constexpr auto kLook = std::chrono::milliseconds(500);
  constexpr auto kAsk = std::chrono::seconds(10);
  constexpr auto kLongest = std::chrono::minutes(10);  // that Slurm may give no answer
  const int there = batch.tasks - static_cast<int>(missing_tasks(folder, batch).size());
  JobState state;
  {
    Progress progress(kind, batch.tasks, "tasks", there);
    Clock::time_point asked = Clock::now(), answered = asked;
    while (true) {
      stop_if_interrupted();
      if (is_made(folder, batch)) {
        progress.show(batch.tasks - there);
        return 0;
      }
      const int done = batch.tasks - static_cast<int>(missing_tasks(folder, batch).size());
      progress.show(std::max(0, done - there));
      const bool over = is_there(folder / "state/collect.failed");
      if (over || Clock::now() - asked > kAsk) {
        asked = Clock::now();
        try {
          state = state_of_job(folder, batch);
          answered = asked;
          if (over || !state.is_active()) break;
        } catch (const Error& error) {
          // tasks go on while Slurm is started anew
          if (error.fault() != Fault::environment || asked - answered > kLongest) throw;
        }
      }
      std::this_thread::sleep_for(kLook);
    }
  }
  text += words_of_state(folder, batch, state);
  return state.made ? 0 : static_cast<int>(Fault::check_failed);
}

// What a process has open is something else in a task.
void refuse_open_files(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    const std::string file = argument.substr(argument.find('=') + 1);  // of --option=FILE
    const bool is_open =
        file.starts_with("/dev/fd/") || file.starts_with("/dev/std") || file.starts_with("/proc/");
    if (is_open && is_there(file))
      throw input_error("is not the same in a task; name a file that stays").at({file, 0, {}});
  }
}

}  // namespace

SubmitResult submit(const SubmitJob& job, const DividedWork& work) {
  check_slurm_options(job.slurm);
  refuse_open_files(job.arguments);
  const fs::path folder = job_folder_of(work.output);
  if (folder.string().find('\\') != std::string::npos) {
    throw input_error("Slurm takes no backslash in the name of a folder")
        .at({folder.string(), 0, {}});
  }

  // a run starts as a process before it starts to work
  DividedWork measured = work;
  measured.start_s += seconds_of([&] { run_child({own_program(), "--version"}, ""); });
  if (job.tasks > std::min<long>(work.pieces, job.most_tasks)) {
    throw input_error("must be at most the number of {}, {}, and at most {}; got {}",
                      work.things,
                      work.pieces,
                      job.most_tasks,
                      job.tasks)
        .at({{}, 0, "--tasks"});
  }
  const TaskSizes planned = job.tasks > 0 ? sizes_of_tasks(measured, measured.start_s, job.tasks)
                                          : sizes_of_tasks(measured, job.most_tasks);
  BatchJob batch = batch_job_of(job, work, planned);
  if (job.dry_run) {
    bool is_active = false;
    batch = settle(folder, batch, is_active, false);
    const TaskSizes sizes = sizes_of_tasks(measured, measured.start_s, batch.tasks);
    return {dry_run(batch, folder, job.slurm, sizes, missing_tasks(folder, batch)), 0};
  }
  require_slurm();
  const bool is_new = !is_there(folder);
  make_folder(folder);
  SubmitResult result;
  try {
    result.text = queue_missing(job, folder, measured, batch);
  } catch (const Error&) {
    if (is_new) remove_file(folder);
    throw;
  }
  if (is_made(folder, batch)) return result;
  const std::string named = shell_word(folder.string());
  if (!job.wait) {
    result.text += fmt::format("polhode status {}\npolhode cancel {}\n", named, named);
    return result;
  }
  try {
    result.code = wait_for(folder, batch, job.progress, result.text);
  } catch (const Error& error) {
    if (error.fault() != Fault::interrupted) throw;
    throw Error(error.fault(),
                fmt::format("interrupted; the job goes on: polhode status {}", named));
  }
  return result;
}

std::string cancel(const fs::path& folder) {
  const BatchJob batch = read_job(folder);
  const JobState state = state_of_job(folder, batch);
  std::vector<std::string> numbers;
  for (const Submission& one : batch.submissions) {
    for (const std::string& number : {one.array, one.collecting})
      if (!number.empty()) numbers.push_back(number);
  }
  require_slurm();
  if (!state.is_active()) return fmt::format("{}: nothing is queued\n", one_line(folder.string()));
  if (const std::optional<std::string> failed = cancel_in_slurm(numbers))
    throw environment_error("{}", *failed);
  return fmt::format("{}: taken back; submit it again, and it goes on from what is done\n",
                     one_line(folder.string()));
}

}  // namespace polhode
