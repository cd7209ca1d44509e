// SPDX-License-Identifier: MIT
// Numbers that theory gives for a motion: rates, angles, periods, energies. `inspect` prints them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/motion.h"
#include "motion/quantity.h"

namespace polhode {

// The name with its unit as suffix, such as "precession_rate_rad_per_s"; ratios and verdicts have
// no suffix.
std::string key_of(const Quantity& quantity);

// The quantities that are defined for this body and this start, in the order in which `inspect`
// prints them: energies, angular momentum and angular speed first; with loads that turn the body,
// only these. `model` is that of `spec`. Throws Error (input) as start_state does. Formulas: Landau
// and Lifshitz, Mechanics, sections 33, 35 and 37; van Zon and Schofield, J. Comput. Phys. 225
// (2007) 145 (flip time 2K/|lambda|).
std::vector<Quantity> derived_quantities(const BodyModel& model, const MotionSpec& spec);

// The value of the quantity with that key_of(); absent if there is none.
std::optional<double> value_of(const std::vector<Quantity>& quantities, const std::string& key);

}  // namespace polhode
