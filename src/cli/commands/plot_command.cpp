// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/plot.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_plot(CLI::App& command) {
  auto job = std::make_shared<PlotJob>();
  add_scene(command, job->scene);
  command.add_option("PLOT", job->name, "quantity over time, or diagram")
      ->required()
      ->type_name("PLOT");
  add_text(command, "-o,--output", job->output, "picture (.svg, .png, .pdf) or table (.csv)")
      ->required()
      ->type_name("OUT");
  add_number(command, "--at", job->at, "time of motion whose point is marked in a diagram")
      ->type_name("SECONDS");
  add_settings(command, job->overrides.settings);
  add_numerics_options(command, job->overrides);
  return [job] {
    draw_plot(*job);
    return 0;
  };
}

}  // namespace polhode
