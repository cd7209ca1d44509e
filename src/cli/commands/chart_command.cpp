// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/chart.h"
#include "app/commands/chart_pictures.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_chart(CLI::App& command) {
  auto job = std::make_shared<ChartJob>();
  auto progress = std::make_shared<ProgressOptions>();
  auto pictures = std::make_shared<bool>(false);
  add_scenes(command, job->scenes);
  add_text(command,
           "-o,--output",
           job->output,
           "folder for chart.csv, .svg, .png and .pdf (default: output/SCENE_chart)")
      ->type_name("DIR");
  add_text(command, "--methods", job->methods, "only these, separated by commas")
      ->type_name("METHODS");
  command.add_flag("--pictures", *pictures, "compare drawing settings instead of methods");
  add_text(command,
           "--size",
           job->overrides.size,
           "picture size with --pictures (default: the scene's, at most 960x540)")
      ->type_name("WxH");
  add_text(command,
           "--accuracy",
           job->overrides.accuracy,
           "the accuracy that the chart marks (default: what the scene needs)")
      ->type_name("RAD|PX");
  add_settings(command, job->overrides.settings);
  add_progress(command, *progress);
  return [job, progress, pictures] {
    job->progress = progress_of(*progress);
    print_out(*pictures ? chart_pictures(*job) : chart(*job));
    return 0;
  };
}

}  // namespace polhode
