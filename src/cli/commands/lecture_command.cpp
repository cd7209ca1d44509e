// SPDX-License-Identifier: MIT
#include <memory>

#include <fmt/ranges.h>

#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"
#include "lecture/lecture.h"
#include "lecture/lecture_plan.h"

namespace polhode {

namespace {

// the options of the command, which are parsed into the job and beside it
struct LectureOptions {
  LectureJob job;
  ProgressOptions progress;
  std::optional<int> jobs;

  LectureJob checked() const {
    if (jobs && *jobs < 1) {
      throw input_error("must be greater than 0, got {}", *jobs).at({{}, 0, "--jobs"});
    }
    LectureJob checked = job;
    checked.jobs = jobs.value_or(job.jobs);
    checked.progress = progress_of(progress);
    return checked;
  }
};

std::shared_ptr<LectureOptions> add_lecture_options(CLI::App& command) {
  auto options = std::make_shared<LectureOptions>();
  LectureJob* job = &options->job;
  command.add_option("deck", job->deck, "Markdown file whose pictures name scenes")
      ->required()
      ->type_name("DECK");
  add_text(command, "-o,--output", job->output, "folder (default: output/DECK_lecture)")
      ->type_name("DIR");
  std::vector<std::string> names;
  for (const LectureOutput& output : lecture_outputs())
    names.push_back(output.name);
  add_text(command,
           "--to",
           job->to,
           fmt::format("only these, separated by commas: {} (default: all that can be made here)",
                       fmt::join(names, ", ")))
      ->type_name("DOCUMENTS");
  command.add_flag("--allow-outside",
                   job->allow_outside,
                   "allow the deck to use files outside its folder; only for decks that you trust");
  add_text(
      command, "--size", job->settings.size, "size of all pictures (default: each scene's own)")
      ->type_name("WxH");
  add_text(
      command, "--fps", job->settings.fps, "frame rate of all films (default: each scene's own)")
      ->type_name("N");
  add_text(command,
           "--theme",
           job->settings.theme,
           "colours of all pictures: dark, light, projector or print (default: each scene's own)")
      ->type_name("THEME");
  add_text(command, "--quality", job->settings.quality, "draft, lecture or archive")
      ->type_name("QUALITY");
  add_whole_number(command, "--jobs", options->jobs, "films rendered at the same time (default: 2)")
      ->type_name("N");
  add_part(command, job->part);
  add_progress(command, options->progress);
  return options;
}

}  // namespace

Action define_lecture(CLI::App& command) {
  const std::shared_ptr<LectureOptions> options = add_lecture_options(command);
  return [options] {
    const LectureResult result = lecture(options->checked());
    int code = 0;
    for (const Error& problem : result.problems) {
      print_err(fmt::format("polhode: {}\n", problem.what()));
      code = std::max(code, static_cast<int>(problem.fault()));
    }
    print_out(result.summary);
    return code;
  };
}

Divide divide_lecture(CLI::App& command) {
  const std::shared_ptr<LectureOptions> options = add_lecture_options(command);
  return [options] {
    return divided_lecture(options->checked());
  };
}

}  // namespace polhode
