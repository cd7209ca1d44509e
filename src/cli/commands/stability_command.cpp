// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/stability.h"
#include "base/error.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

namespace {

// the options of the command, which are parsed into the job and beside it
struct StabilityOptions {
  StabilityJob job;
  ProgressOptions progress;
  std::optional<double> turns, allowed;
  std::optional<int> jobs;

  StabilityJob checked() const {
    const auto positive = [](const auto& value, const char* option) {
      if (value && !(*value > 0)) {
        throw input_error("must be greater than 0, got {}", *value).at({{}, 0, option});
      }
    };
    positive(turns, "--turns");
    positive(allowed, "--allowed");
    positive(jobs, "--jobs");
    StabilityJob checked = job;
    checked.turns = turns.value_or(job.turns);
    checked.allowed_rad = allowed.value_or(job.allowed_rad);
    checked.jobs = jobs.value_or(job.jobs);
    checked.progress = progress_of(progress);
    return checked;
  }
};

std::shared_ptr<StabilityOptions> add_stability_options(CLI::App& command) {
  auto options = std::make_shared<StabilityOptions>();
  StabilityJob* job = &options->job;
  add_scenes(command, job->scenes);
  add_text(command,
           "-o,--output",
           job->output,
           "folder for stability.csv and the pictures (default: output/SCENE_stability)")
      ->type_name("DIR");
  add_text(command, "--methods", job->methods, "only these, separated by commas")
      ->type_name("METHODS");
  add_text(command, "--x", job->x, "scene key on the horizontal axis; spin: a factor on the spin")
      ->type_name("KEY");
  add_text(command, "--y", job->y, "scene key on the vertical axis")->type_name("KEY");
  add_text(
      command, "--x-range", job->x_range, "range of the axis (default: around the scene's value)")
      ->type_name("A:B");
  add_text(
      command, "--y-range", job->y_range, "range of the axis (default: around the scene's value)")
      ->type_name("A:B");
  add_text(command, "--cells", job->cells, "number of cells, horizontal x vertical")
      ->type_name("NxM");
  add_number(command,
             "--turns",
             options->turns,
             "length of each run, in turns at the rate of the motion (default: 100)")
      ->type_name("N");
  add_number(command, "--allowed", options->allowed, "allowed attitude error, rad (default: 0.1)")
      ->type_name("RAD");
  add_whole_number(command, "--jobs", options->jobs, "threads (default: one per processor)")
      ->type_name("N");
  add_settings(command, job->settings);
  add_part(command, job->part);
  add_progress(command, options->progress);
  return options;
}

}  // namespace

Action define_stability(CLI::App& command) {
  const std::shared_ptr<StabilityOptions> options = add_stability_options(command);
  return [options] {
    print_out(stability(options->checked()));
    return 0;
  };
}

Divide divide_stability(CLI::App& command) {
  const std::shared_ptr<StabilityOptions> options = add_stability_options(command);
  return [options] {
    return divided_stability(options->checked());
  };
}

}  // namespace polhode
