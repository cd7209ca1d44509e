// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/inspect.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_inspect(CLI::App& command) {
  auto job = std::make_shared<InspectJob>();
  add_scene(command, job->scene);
  command.add_flag("--json", job->json, "print JSON with units in the key names");
  add_settings(command, job->overrides.settings);
  add_numerics_options(command, job->overrides);
  return [job] {
    print_out(inspect(*job));
    return 0;
  };
}

}  // namespace polhode
