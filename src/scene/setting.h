// SPDX-License-Identifier: MIT
// Values of a scene that the command line gives.
#pragma once

#include <string>

namespace polhode {

// A value that replaces the one in the file: `--set KEY=VALUE`. The key is a path as the file could
// spell it, such as "motion.spin.body[2]" or "body.solid.radius_cm"; the value is TOML, or words
// that count as text.
struct Setting {
  std::string key, value;
};

// Throws Error (input), without a place, for text that is not KEY=VALUE.
Setting parse_setting(const std::string& text);

// Its key in errors: "--set KEY".
std::string option_of(const Setting& setting);

}  // namespace polhode
