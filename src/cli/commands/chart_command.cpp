// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/chart.h"
#include "app/commands/chart_pictures.h"
#include "base/error.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

namespace {

// the options of the command, which are parsed into the job and beside it
struct ChartOptions {
  ChartJob job;
  ProgressOptions progress;
  bool pictures = false;

  ChartJob checked() const {
    if (pictures && job.part.shard)
      throw input_error("is for charts of methods, not with --pictures").at({{}, 0, "--shard"});
    if (pictures && !job.methods.empty())
      throw input_error("is for charts of methods, not with --pictures").at({{}, 0, "--methods"});
    if (pictures && job.overrides.accuracy)
      throw input_error("is for charts of methods, not with --pictures").at({{}, 0, "--accuracy"});
    ChartJob checked = job;
    checked.progress = progress_of(progress);
    return checked;
  }
};

std::shared_ptr<ChartOptions> add_chart_options(CLI::App& command) {
  auto options = std::make_shared<ChartOptions>();
  ChartJob* job = &options->job;
  add_scenes(command, job->scenes);
  add_text(command,
           "-o,--output",
           job->output,
           "folder for chart.csv, .svg, .png and .pdf (default: output/SCENE_chart)")
      ->type_name("DIR");
  add_text(command, "--methods", job->methods, "only these, separated by commas")
      ->type_name("METHODS");
  command.add_flag("--pictures", options->pictures, "compare drawing settings instead of methods");
  add_text(command,
           "--size",
           job->overrides.size,
           "picture size (default: the scene's; with --pictures at most 960x540)")
      ->type_name("WxH");
  add_text(command,
           "--accuracy",
           job->overrides.accuracy,
           "the accuracy that the chart marks (default: what the scene needs)")
      ->type_name("RAD|PX");
  add_settings(command, job->overrides.settings);
  add_part(command, job->part);
  add_progress(command, options->progress);
  return options;
}

}  // namespace

Action define_chart(CLI::App& command) {
  const std::shared_ptr<ChartOptions> options = add_chart_options(command);
  return [options] {
    const ChartJob job = options->checked();
    print_out(options->pictures ? chart_pictures(job) : chart(job));
    return 0;
  };
}

Divide divide_chart(CLI::App& command) {
  const std::shared_ptr<ChartOptions> options = add_chart_options(command);
  return [options] {
    if (options->pictures)
      throw input_error("cannot be divided; run it here").at({{}, 0, "--pictures"});
    return divided_chart(options->checked());
  };
}

}  // namespace polhode
