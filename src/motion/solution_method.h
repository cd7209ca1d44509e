// SPDX-License-Identifier: MIT
// The ways to find a motion, from the least to the most, and the choice among them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/motion_spec.h"
#include "motion/trajectory.h"

namespace polhode {

// A way to find the motion. To add one: a row in solution_methods(), ordered from least to most.
struct SolutionMethod {
  std::string name;
  std::string doc;
  bool closed_form = false;
  bool with_translation = false;  // integrates place and momentum of the centre of mass too
  bool splits = false;  // into flows that are known exactly; takes symplectic methods only
  // "" when it can take the scene, else the reason why not
  std::string (*why_not)(const BodyModel& model);
  // closed forms only
  std::unique_ptr<Trajectory> (*make)(const BodyModel& model, const State& start);
};

const std::vector<SolutionMethod>& solution_methods();

// The least model that takes the scene, or the one asked for, and in one phrase why. Throws Error
// (input) when the one asked for cannot take the scene.
const SolutionMethod& choose_solution_method(const BodyModel& model,
                                             const NumericsSpec& numerics,
                                             std::string& reason);

// The model with as many degrees of freedom as its loads need.
BodyModel with_needed_degrees(BodyModel model);

}  // namespace polhode
