// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/section.h"
#include "base/error.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_section(CLI::App& command) {
  auto job = std::make_shared<SectionJob>();
  auto progress = std::make_shared<ProgressOptions>();
  auto starts = std::make_shared<std::optional<int>>();
  auto crossings = std::make_shared<std::optional<int>>();
  auto jobs = std::make_shared<std::optional<int>>();
  add_scene(command, job->scene);
  add_text(command,
           "-o,--output",
           job->output,
           "folder for section.csv and section.png (default: output/SCENE_section)")
      ->type_name("DIR");
  add_whole_number(command, "--starts", *starts, "motions beside that of the scene (default: 60)")
      ->type_name("N");
  add_whole_number(command, "--crossings", *crossings, "crossings of each motion (default: 500)")
      ->type_name("N");
  add_whole_number(command, "--jobs", *jobs, "threads (default: one per processor)")
      ->type_name("N");
  add_settings(command, job->settings);
  add_progress(command, *progress);
  return [=] {
    if (*jobs && **jobs < 1)
      throw input_error("must be greater than 0, got {}", **jobs).at({{}, 0, "--jobs"});
    job->starts = starts->value_or(job->starts);
    job->crossings = crossings->value_or(job->crossings);
    job->jobs = jobs->value_or(job->jobs);
    job->progress = progress_of(*progress);
    print_out(section(*job));
    return 0;
  };
}

}  // namespace polhode
