// SPDX-License-Identifier: MIT
// Options that several commands take.
#pragma once

#include <CLI/CLI.hpp>

#include "app/load.h"

namespace polhode {

// --method, --step, --tolerance, --accuracy
inline void add_numerics_options(CLI::App& command, Overrides& overrides) {
  command.add_option("--method", overrides.method, "integrator, see `polhode list methods`")
      ->type_name("NAME");
  command.add_option("--step", overrides.step, "step of fixed-step methods, seconds")
      ->type_name("H");
  command.add_option("--tolerance", overrides.tolerance, "local error of adaptive methods")
      ->type_name("E");
  command
      .add_option("--accuracy",
                  overrides.accuracy,
                  "attitude error allowed over the whole motion: 0.1px, or radians")
      ->type_name("A");
}

}  // namespace polhode
