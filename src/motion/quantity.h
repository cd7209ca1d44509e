// SPDX-License-Identifier: MIT
// A number that theory gives, with its name and its unit.
#pragma once

#include <string>

namespace polhode {

// The units: time in s, angle in rad, rate in rad/s, growth in 1/s, energy in J, momentum in kg
// m^2/s. `none` is a ratio; a verdict is 0 (no) or 1 (yes).
enum class QuantityUnit { none, time, angle, rate, growth, energy, momentum, verdict };

// One number with its name.
struct Quantity {
  std::string name;   // without unit: "precession_rate"
  QuantityUnit unit;  // the value is in SI units and radians
  double value;
};

}  // namespace polhode
