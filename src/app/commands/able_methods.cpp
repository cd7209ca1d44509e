// SPDX-License-Identifier: MIT
#include "app/commands/able_methods.h"

#include <spdlog/spdlog.h>

#include "base/error.h"

namespace polhode {

std::vector<const StepperInfo*> able_methods(const std::vector<const StepperInfo*>& methods,
                                             const std::string& asked,
                                             const BodyModel& model,
                                             const std::string& file,
                                             MethodObstacle obstacle) {
  std::vector<const StepperInfo*> able;
  for (const StepperInfo* method : methods) {
    if (obstacle(*method, model).empty()) able.push_back(method);
  }
  if (able.empty()) {
    throw input_error(
        "{} cannot take {}: {}", methods.front()->name, file, obstacle(*methods.front(), model))
        .at({{}, 0, "--methods"});
  }
  if (asked.empty()) return able;
  for (const StepperInfo* method : methods) {
    if (const std::string reason = obstacle(*method, model); !reason.empty())
      spdlog::warn("{} is left out for {}: {}", method->name, file, reason);
  }
  return able;
}

}  // namespace polhode
