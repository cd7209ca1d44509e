// SPDX-License-Identifier: MIT
// What methods cost, as measured: how method = "auto" finds the cheapest for a scene.
#pragma once

#include <string>
#include <vector>

#include "model/body_model.h"

namespace polhode {

// Motions on which methods rank alike.
enum class ProblemKind {
  free,    // nothing turns the body
  top,     // symmetric, gravity on its axis
  heavy,   // any other body that gravity turns
  loaded,  // other torques
  six,     // forces that depend on the place: six degrees of freedom
};
ProblemKind problem_kind(const BodyModel& model);

// One measured cost: of finding the attitude within that error to the end of a motion, per radian
// that the body turns or swings (motion/scales.h, typical_rate).
struct MethodCost {
  ProblemKind kind;
  double accuracy_rad;
  std::string method;
  double ns_per_rad;
};

// The whole table, written by tests/bench/method_costs.cpp.
const std::vector<MethodCost>& method_costs();

// The methods that can take the model and reach the accuracy, the cheapest first; of the splittings
// only if asked. Beyond the finest accuracy measured, those that reach that one.
std::vector<MethodCost> cheapest_methods(const BodyModel& model,
                                         double accuracy_rad,
                                         bool splittings_only);

}  // namespace polhode
