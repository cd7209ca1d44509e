// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/simulate.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_simulate(CLI::App& command) {
  auto job = std::make_shared<SimulateJob>();
  add_scene(command, job->scene);
  add_text(command, "-o,--output", job->output, "CSV file, or - for standard output")
      ->required()
      ->type_name("FILE.csv");
  add_number(command, "--rate", job->rate, "rows per second (default: the scene's frame rate)")
      ->type_name("HZ");
  add_settings(command, job->overrides.settings);
  add_numerics_options(command, job->overrides);
  return [job] {
    write_csv(*job);
    return 0;
  };
}

}  // namespace polhode
