// SPDX-License-Identifier: MIT
#include <memory>

#include <fmt/format.h>

#include "app/inspect.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {

Action define_inspect(CLI::App& command) {
  auto job = std::make_shared<InspectJob>();
  command.add_option("scene", job->scene, "scene file")->required()->type_name("SCENE");
  command.add_flag("--json", job->json, "as JSON, units in the names of the keys");
  add_numerics_options(command, job->overrides);
  return [job] {
    fmt::print("{}", inspect(*job));
    return 0;
  };
}

}  // namespace polhode
