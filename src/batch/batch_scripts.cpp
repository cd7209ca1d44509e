// SPDX-License-Identifier: MIT
#include "batch/batch_scripts.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/one_line.h"
#include "base/shell_word.h"
#include "base/version.h"

namespace polhode {
namespace {

// what sbatch reads at the top of a script
std::string head_of(const BatchJob& job, const SlurmOptions& options) {
  std::string text = fmt::format("#!/bin/sh\n#SBATCH --job-name=polhode-{}\n", job.command);
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) text += fmt::format("#SBATCH --{}={}\n", option, value);
  };
  add("partition", options.partition);
  add("account", options.account);
  add("time", options.time);
  add("mem", options.memory);
  return text;
}

std::string last_of_head(const SlurmOptions& options) {
  return options.more.empty() ? "" : fmt::format("#SBATCH {}\n", options.more);
}

std::string places(const BatchJob& job, const std::filesystem::path& folder) {
  return fmt::format(
      "program={}\njob={}\n", shell_quoted(job.program), shell_quoted(folder.string()));
}

// the command with what `submit` adds; the user's words come last, so that they count
std::string call_of(const BatchJob& job, const std::string& shard) {
  std::string text = "\"$program\" " + job.command;
  if (job.has_jobs) text += " --jobs \"${SLURM_CPUS_ON_NODE:-1}\"";
  text += " --progress none";
  for (const std::string& option : job.options)
    text += " " + shell_quoted(option);
  text += shard + " --submitted " + job.hash;
  return text + " \\\n  " + shell_line(job.arguments) + "\n";
}

std::string what_it_is(const BatchJob& job) {
  return one_line(fmt::format("polhode {} {}", job.command, shell_line(job.arguments)));
}

// a file of the folder for --output, in which % begins a pattern
std::string log_pattern(const std::filesystem::path& folder, const char* name) {
  std::string pattern;
  for (const char c : folder.string())
    pattern += c == '%' ? std::string("%%") : std::string(1, c);
  return pattern + "/logs/" + name;
}

}  // namespace

std::string shell_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words)
    line += (line.empty() ? "" : " ") + shell_quoted(word);
  return line;
}

void check_slurm_options(const SlurmOptions& options) {
  const auto check = [](const std::string& value, const char* option, bool one_word) {
    const bool wrong = std::any_of(value.begin(), value.end(), [&](char c) {
      const auto byte = static_cast<unsigned char>(c);
      return byte < ' ' || byte == 0x7f || (one_word && c == ' ');
    });
    if (!wrong) return;
    throw input_error("must be one {}", one_word ? "word" : "line").at({{}, 0, option});
  };
  check(options.partition, "--partition", true);
  check(options.account, "--account", true);
  check(options.time, "--time", true);
  check(options.memory, "--mem", true);
  check(options.more, "--sbatch", false);
}

std::string task_script(const BatchJob& job,
                        const std::filesystem::path& folder,
                        const SlurmOptions& options) {
  std::string text = head_of(job, options);
  text += "#SBATCH --requeue\n#SBATCH --open-mode=append\n";
  if (job.alone) text += "#SBATCH --exclusive\n";
  text += last_of_head(options);
  text += fmt::format(
      "# Written by polhode {}. A task of: {}\n"
      "# Without Slurm, the first of its {} tasks: SLURM_ARRAY_TASK_ID=1 sh tasks.sh\n",
      program_version(),
      what_it_is(job),
      job.tasks);
  text += places(job, folder);
  text += fmt::format(
      "task=$SLURM_ARRAY_TASK_ID\n"
      "trap : TERM INT  # the program ends by itself, and keeps what is finished\n"
      "echo \"task $task of {} on $(uname -n), $(date '+%F %T')\"\n"
      "cd {} || exit 3\n"
      "rm -f \"$job/state/$task.failed\"\n",
      job.tasks,
      shell_quoted(job.working_folder));
  text += call_of(job, fmt::format(" --shard \"$task/{}\"", job.tasks));
  text +=
      "code=$?\n"
      "if [ $code -eq 0 ]; then : > \"$job/state/$task.done\"; else echo $code > "
      "\"$job/state/$task.failed\"; fi || code=3\n"
      "exit $code\n";
  return text;
}

std::string collecting_script(const BatchJob& job,
                              const std::filesystem::path& folder,
                              const SlurmOptions& options) {
  std::string text = head_of(job, options);
  text += "#SBATCH --requeue\n#SBATCH --open-mode=append\n";
  text += last_of_head(options);
  text += fmt::format(
      "# Written by polhode {}. Collects the tasks of: {}\n", program_version(), what_it_is(job));
  text += places(job, folder);
  text += fmt::format(
      "trap : TERM INT\n"
      "rm -f \"$job/state/collect.failed\"\n"
      "fail() {{ echo \"$1\" > \"$job/state/collect.failed\"; exit \"$1\"; }}\n"
      "\"$program\" status --finished \"$job\" || fail $?\n"
      "cd {} || fail 3\n",
      shell_quoted(job.working_folder));
  text += call_of(job, "");
  text +=
      "code=$?\n"
      "[ $code -eq 0 ] || fail $code\n"
      ": > \"$job/state/collected\" || fail 3\n"
      "rm -f \"$job\"/state/*.done \"$job\"/state/*.failed\n";
  return text;
}

std::vector<std::string> call_for_tasks(const std::filesystem::path& folder,
                                        const std::vector<int>& tasks,
                                        const SlurmOptions& options) {
  std::string array = ranges_of(tasks);
  if (options.at_once > 0) array += fmt::format("%{}", options.at_once);
  return {"sbatch",
          "--parsable",
          "--array=" + array,
          "--chdir=" + folder.string(),
          "--output=" + log_pattern(folder, "task-%a.log"),
          (folder / "tasks.sh").string()};
}

std::vector<std::string> call_for_collecting(const std::filesystem::path& folder,
                                             const std::string& after) {
  std::vector<std::string> words = {"sbatch", "--parsable"};
  if (!after.empty()) words.push_back("--dependency=afterany:" + after);
  words.insert(words.end(),
               {"--chdir=" + folder.string(),
                "--output=" + log_pattern(folder, "collect.log"),
                (folder / "collect.sh").string()});
  return words;
}

}  // namespace polhode
