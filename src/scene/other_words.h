// SPDX-License-Identifier: MIT
// Words that people try in scenes, and what does it here.
#pragma once

#include <string>

namespace polhode {

// What a word is here, such as "motion.torque = ..." for "damping", whatever unit it has behind it
// ("tilt_deg"); empty: it is none.
std::string instead_of(const std::string& name);

// " (here it is ...)", or nothing.
std::string instead_hint(const std::string& name);

}  // namespace polhode
