// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <sstream>

#include "base/error.h"
#include "base/nearest.h"
#include "base/system/console.h"
#include "batch/submit.h"
#include "batch/task_states.h"
#include "cli/command.h"
#include "cli/parse_errors.h"
#include "cli/shared_options.h"

namespace polhode {
namespace {

const Command& find_divisible(const std::string& name) {
  std::vector<std::string> names;
  for (const Command& command : commands()) {
    if (command.divide == nullptr) continue;
    if (command.name == name) return command;
    names.emplace_back(command.name);
  }
  throw input_error("'{}' is no work that can be divided{}", name, suggestion(name, names))
      .at({{}, 0, kSubmit});
}

// The work that the words after `submit` mean; nothing if they asked for help, which is printed.
std::optional<DividedWork> work_of(const std::vector<std::string>& words) {
  const Command& row = find_divisible(words.front());
  CLI::App app("", "polhode");
  app.require_subcommand(1);
  CLI::App* command = app.add_subcommand(row.name, row.doc);
  const Divide divide = row.divide(*command);
  try {
    parse_words(app, words);
  } catch (const CLI::Success& request) {
    std::ostringstream text;
    app.exit(request, text, text);
    print_out(text.str());
    return {};
  } catch (const CLI::ParseError& error) {
    throw explain(error, app, words);
  }
  for (const char* option : {"--shard", "--submitted"}) {
    if (command->count(option) > 0)
      throw input_error("is given by submit to each task; leave it out").at({{}, 0, option});
  }
  return divide();
}

struct SubmitOptions {
  std::vector<std::string> words;
  SubmitJob job;
  std::optional<int> most_tasks, tasks, at_once;
  ProgressOptions progress;
};

}  // namespace

Action define_submit(CLI::App& command) {
  auto options = std::make_shared<SubmitOptions>();
  SlurmOptions* slurm = &options->job.slurm;
  command
      .add_option(
          "work", options->words, "render, lecture, chart, stability or section, and its arguments")
      ->required()
      ->type_name("WORK");
  add_text(command, "--partition", slurm->partition, "partition of the cluster")->type_name("NAME");
  add_text(command, "--time", slurm->time, "limit of each task, as Slurm writes it: 30, 1:00:00")
      ->type_name("TIME");
  add_text(command, "--mem", slurm->memory, "memory of each task: 4G")->type_name("SIZE");
  add_text(command, "--account", slurm->account, "account that is charged")->type_name("NAME");
  add_text(command, "--sbatch", slurm->more, "more options of sbatch, as one word in quotes")
      ->type_name("OPTIONS");
  add_whole_number(
      command, "--max-tasks", options->most_tasks, "at most so many tasks (default: 1000)")
      ->type_name("M");
  add_whole_number(
      command, "--tasks", options->tasks, "exactly so many tasks (default: by their measured cost)")
      ->type_name("N");
  add_whole_number(command, "--at-once", options->at_once, "at most so many tasks at a time")
      ->type_name("M");
  command.add_flag("--dry-run",
                   options->job.dry_run,
                   "queue nothing; print the scripts, and how long it would take");
  command.add_flag("--wait", options->job.wait, "wait until everything is made or has failed");
  add_progress(command, options->progress);
  return [options] {
    SubmitJob& job = options->job;
    const auto positive = [](const std::optional<int>& value, const char* option) {
      if (value && *value < 1)
        throw input_error("must be greater than 0, got {}", *value).at({{}, 0, option});
    };
    positive(options->most_tasks, "--max-tasks");
    if (options->most_tasks.value_or(1) > kMostTasks) {
      throw input_error("must be at most {}, got {}", kMostTasks, *options->most_tasks)
          .at({{}, 0, "--max-tasks"});
    }
    positive(options->tasks, "--tasks");
    positive(options->at_once, "--at-once");
    job.tasks = options->tasks.value_or(0);
    job.most_tasks = options->most_tasks.value_or(job.most_tasks);
    job.slurm.at_once = options->at_once.value_or(0);
    job.progress = progress_of(options->progress);
    check_slurm_options(job.slurm);
    const std::optional<DividedWork> work = work_of(options->words);
    if (!work) return 0;
    job.command = options->words.front();
    job.arguments.assign(options->words.begin() + 1, options->words.end());
    const SubmitResult result = submit(job, *work);
    print_out(result.text);
    return result.code;
  };
}

Action define_status(CLI::App& command) {
  struct Options {
    std::string folder;
    bool finished = false;
  };
  auto options = std::make_shared<Options>();
  command.add_option("job", options->folder, "folder of the job, OUTPUT.job, or the output")
      ->required()
      ->type_name("JOB");
  command.add_flag("--finished", options->finished, "fail unless all tasks are done");
  return [options] {
    const std::filesystem::path folder = find_job(options->folder);
    const BatchJob job = read_job(folder);
    const JobState state =
        options->finished ? settled_state(folder, job) : state_of_job(folder, job);
    print_out(words_of_state(folder, job, state));
    const bool all = state.count(TaskProgress::done) == job.tasks;
    return options->finished && !all ? static_cast<int>(Fault::check_failed) : exit_code_of(state);
  };
}

Action define_cancel(CLI::App& command) {
  auto folder = std::make_shared<std::string>();
  command.add_option("job", *folder, "folder of the job, OUTPUT.job, or the output")
      ->required()
      ->type_name("JOB");
  return [folder] {
    print_out(cancel(find_job(*folder)));
    return 0;
  };
}

}  // namespace polhode
