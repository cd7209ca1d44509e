// SPDX-License-Identifier: MIT
#include <memory>

#include <fmt/ranges.h>

#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"
#include "lecture/lecture.h"

namespace polhode {

Action define_lecture(CLI::App& command) {
  auto job = std::make_shared<LectureJob>();
  auto progress = std::make_shared<ProgressOptions>();
  auto jobs = std::make_shared<std::optional<int>>();
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
  add_whole_number(command, "--jobs", *jobs, "films rendered at the same time (default: 2)")
      ->type_name("N");
  add_progress(command, *progress);
  return [=] {
    if (*jobs && **jobs < 1) {
      throw input_error("must be greater than 0, got {}", **jobs).at({{}, 0, "--jobs"});
    }
    job->jobs = jobs->value_or(job->jobs);
    job->progress = progress_of(*progress);
    const LectureResult result = lecture(*job);
    int code = 0;
    for (const Error& problem : result.problems) {
      print_err(fmt::format("polhode: {}\n", problem.what()));
      code = std::max(code, static_cast<int>(problem.fault()));
    }
    print_out(result.summary);
    return code;
  };
}

}  // namespace polhode
