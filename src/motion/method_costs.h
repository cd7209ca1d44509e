// SPDX-License-Identifier: MIT
// Measured costs of the methods, from which method = "auto" chooses the cheapest for a scene.
#pragma once

#include <string>
#include <vector>

#include "model/body_model.h"
#include "motion/motion_spec.h"

namespace polhode {

// Classes of motions on which methods rank alike.
enum class ProblemKind {
  free,    // no torque
  top,     // symmetric, centre of mass on the axis
  heavy,   // any other body with a torque of gravity
  loaded,  // other torques
  six,     // forces that depend on attitude or place: six degrees of freedom
};
// The class of the motions of this model.
ProblemKind problem_kind(const BodyModel& model);

// One measurement: the time to compute the attitude to the end of a motion within that error, per
// radian of typical_rate (motion/scales.h) times duration.
struct MethodCost {
  ProblemKind kind;
  double accuracy_rad;  // attitude error at the end
  std::string method;   // a name from stepper_table()
  double ns_per_rad;    // processor time, ns per radian
};

// All measurements. The table motion/method_costs.inc is written by tests/bench/method_costs.cpp.
const std::vector<MethodCost>& method_costs();

// The methods that can integrate the model and reach the accuracy, cheapest first, as measured at
// the coarsest accuracy that is fine enough. If `numerics` gives a step or a tolerance, only
// methods that use it, unless there are none. With splittings_only, symplectic methods only. For
// accuracies finer than all measured ones, the methods that reached the finest. For a free body,
// methods that are exact without gravity are left out.
std::vector<MethodCost> cheapest_methods(const BodyModel& model,
                                         const NumericsSpec& numerics,
                                         double accuracy_rad,
                                         bool splittings_only);

}  // namespace polhode
