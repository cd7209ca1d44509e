// SPDX-License-Identifier: MIT
// The numbers that theory gives for a motion before any picture: rates, angles, periods, energies.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/motion.h"

namespace polhode {

enum class QuantityUnit { none, time, angle, rate, growth, energy, momentum, verdict };

// One number with its name; a verdict is 0 (no) or 1 (yes).
struct Quantity {
  std::string name;   // without unit: "precession_rate"
  QuantityUnit unit;  // SI and radians
  double value;
};

// name with its unit as suffix: "precession_rate_rad_per_s"
std::string key_of(const Quantity& quantity);

// The numbers that make sense for this body and this start, in the order of a lecture. Formulas:
// Landau and Lifshitz, Mechanics, 33, 35 and 37; van Zon and Schofield, J. Comput. Phys. 225 (2007)
// 145 (flip time 2K/|lambda|).
std::vector<Quantity> derived_quantities(const BodyModel& model, const MotionSpec& spec);

// The value of that key, if the motion has it.
std::optional<double> value_of(const std::vector<Quantity>& quantities, const std::string& key);

}  // namespace polhode
