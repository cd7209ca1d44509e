// SPDX-License-Identifier: MIT
// Which of the methods that are asked for can integrate a scene.
#pragma once

#include <string>
#include <vector>

#include "motion/stepper_table.h"

namespace polhode {

// Those of the methods (at least one) of --methods, whose text is `asked`, that can integrate the
// model of this scene file. If it names methods, a warning tells each that is left out, and why.
// `obstacle`: why_not() or why_not_by_fixed_steps(). Throws Error (input), naming --methods, if
// none can.
std::vector<const StepperInfo*> able_methods(const std::vector<const StepperInfo*>& methods,
                                             const std::string& asked,
                                             const BodyModel& model,
                                             const std::string& file,
                                             MethodObstacle obstacle);

}  // namespace polhode
