// SPDX-License-Identifier: MIT
// Quantities of a motion over time, by name: what a plot can show.
#pragma once

#include <string>
#include <vector>

#include "motion/motion.h"

namespace polhode {

// One name, one or more curves of the same unit.
struct Recorded {
  std::string name;
  std::string title;                // for people
  std::string unit;                 // "rad/s"; "" for ratios
  std::vector<std::string> curves;  // names of the curves, one by one
  // their values at this moment, as many as there are curves
  std::vector<double> (*values)(const Motion& motion, const Sample& sample);
};

const std::vector<Recorded>& recorded_quantities();
std::vector<std::string> recorded_names();

}  // namespace polhode
