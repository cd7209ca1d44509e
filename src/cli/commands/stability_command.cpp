// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/stability.h"
#include "base/error.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_stability(CLI::App& command) {
  auto job = std::make_shared<StabilityJob>();
  auto progress = std::make_shared<ProgressOptions>();
  auto turns = std::make_shared<std::optional<double>>();
  auto allowed = std::make_shared<std::optional<double>>();
  auto jobs = std::make_shared<std::optional<int>>();
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
  add_number(command, "--turns", *turns, "turns of the body in each run (default: 100)")
      ->type_name("N");
  add_number(command, "--allowed", *allowed, "allowed attitude error, rad (default: 0.1)")
      ->type_name("RAD");
  add_whole_number(command, "--jobs", *jobs, "threads (default: one per processor)")
      ->type_name("N");
  add_settings(command, job->settings);
  add_progress(command, *progress);
  return [=] {
    const auto positive = [](const auto& value, const char* option) {
      if (value && !(*value > 0)) {
        throw input_error("must be greater than 0, got {}", *value).at({{}, 0, option});
      }
    };
    positive(*turns, "--turns");
    positive(*allowed, "--allowed");
    positive(*jobs, "--jobs");
    job->turns = turns->value_or(job->turns);
    job->allowed_rad = allowed->value_or(job->allowed_rad);
    job->jobs = jobs->value_or(job->jobs);
    job->progress = progress_of(*progress);
    print_out(stability(*job));
    return 0;
  };
}

}  // namespace polhode
