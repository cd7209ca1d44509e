// SPDX-License-Identifier: MIT
#include "batch/batch_job.h"

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "base/error.h"
#include "base/json.h"
#include "base/numbers.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJobFile = "job.json";

Json json_of(const BatchJob& job) {
  Json submissions = Json::array();
  for (const Submission& one : job.submissions) {
    submissions.push_back(
        {{"array", one.array}, {"collecting", one.collecting}, {"tasks", ranges_of(one.tasks)}});
  }
  return {{"hash", job.hash},
          {"command", job.command},
          {"options", job.options},
          {"arguments", job.arguments},
          {"program", job.program},
          {"working_folder", job.working_folder},
          {"output", job.output},
          {"proof", job.proof},
          {"has_jobs", job.has_jobs},
          {"alone", job.alone},
          {"things", job.things},
          {"pieces", job.pieces},
          {"tasks", job.tasks},
          {"longest_s", job.longest_s},
          {"submissions", submissions}};
}

// what is handed to Slurm's programs is a number, whoever wrote the file
std::string slurm_number(const std::string& text) {
  const bool is_number = text.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? text : "";
}

// a whole number from 1 to `most`; 0: something else
int count_in(const Json& json, int most) {
  const auto number = json.get<double>();
  return number >= 1.0 && number <= most ? static_cast<int>(number) : 0;
}

BatchJob job_from(const Json& json) {
  BatchJob job;
  json.at("hash").get_to(job.hash);
  json.at("command").get_to(job.command);
  json.at("options").get_to(job.options);
  json.at("arguments").get_to(job.arguments);
  json.at("program").get_to(job.program);
  json.at("working_folder").get_to(job.working_folder);
  json.at("output").get_to(job.output);
  json.at("proof").get_to(job.proof);
  json.at("has_jobs").get_to(job.has_jobs);
  json.at("alone").get_to(job.alone);
  json.at("things").get_to(job.things);
  job.pieces = count_in(json.at("pieces"), std::numeric_limits<int>::max());
  job.tasks = count_in(json.at("tasks"), kMostTasks);
  json.at("longest_s").get_to(job.longest_s);
  for (const Json& one : json.at("submissions")) {
    job.submissions.push_back({slurm_number(one.at("array")),
                               slurm_number(one.at("collecting")),
                               numbers_in(one.at("tasks").get<std::string>())});
  }
  return job;
}

}  // namespace

fs::path job_folder_of(const fs::path& output) {
  fs::path whole = absolute_path(output);
  if (!whole.has_filename()) whole = whole.parent_path();  // "maps/"
  whole += ".job";
  return whole;
}

BatchJob read_job(const fs::path& folder) {
  const fs::path file = folder / kJobFile;
  const auto refuse = [&] {
    throw input_error("was not written by `polhode submit`; delete the folder to start again")
        .at({file.string(), 0, {}});
  };
  BatchJob job;
  try {
    job = job_from(parse_foreign_json(read_file(file)));
  } catch (const Json::exception&) {
    refuse();
  }
  if (job.tasks == 0 || job.pieces == 0) refuse();
  return job;
}

void write_job(const fs::path& folder, const BatchJob& job) {
  std::string text;
  try {
    text = json_of(job).dump(1) + "\n";
  } catch (const Json::exception&) {
    throw input_error("names of files and folders must be UTF-8 to be submitted");
  }
  write_file(folder / kJobFile, text);
}

fs::path find_job(const fs::path& named) {
  for (const fs::path& folder : {absolute_path(named), job_folder_of(named)}) {
    if (is_there(folder / kJobFile)) return folder;
  }
  throw input_error("is not the folder of a job of `polhode submit`, which is called OUTPUT.job")
      .at({named.string(), 0, {}});
}

bool is_made(const fs::path& folder, const BatchJob& job) {
  if (!is_there(folder / "state/collected") || !is_there(job.output)) return false;
  return std::all_of(job.proof.begin(), job.proof.end(), [&](const std::string& name) {
    return is_there(fs::path(job.output) / name);
  });
}

fs::path mark_of_task(const fs::path& folder, int task, const char* what) {
  return folder / "state" / fmt::format("{}.{}", task, what);
}

fs::path log_of_task(const fs::path& folder, int task) {
  return folder / "logs" / fmt::format("task-{}.log", task);
}

std::vector<int> missing_tasks(const fs::path& folder, const BatchJob& job) {
  // one look at the folder, not one at each task: shared folders are slow
  std::set<std::string> there;
  if (is_there(folder / "state")) {
    for (const fs::path& entry : entries_of(folder / "state"))
      there.insert(entry.filename().string());
  }
  std::vector<int> missing;
  for (int task = 1; task <= job.tasks; ++task) {
    if (!there.contains(mark_of_task(folder, task, "done").filename().string()))
      missing.push_back(task);
  }
  return missing;
}

std::string ranges_of(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1)
      ++last;
    if (!text.empty()) text += ',';
    text += std::to_string(numbers[i]);
    if (last > i) text += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return text;
}

std::vector<int> numbers_in(const std::string& ranges) {
  std::vector<int> numbers;
  std::istringstream in(ranges.substr(0, ranges.find('%')));
  for (std::string range; std::getline(in, range, ',');) {
    const std::size_t dash = range.find('-');
    const std::optional<int> first = parse_integer(range.substr(0, dash));
    const std::optional<int> last =
        dash == std::string::npos ? first : parse_integer(range.substr(dash + 1));
    if (!first || !last || *first < 0 || *last > kMostTasks) continue;
    for (int number = *first; number <= *last && numbers.size() < kMostTasks; ++number)
      numbers.push_back(number);
  }
  return numbers;
}

}  // namespace polhode
