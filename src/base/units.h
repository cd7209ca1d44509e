// SPDX-License-Identifier: MIT
// The units a scene file may use. Inside the program everything is SI and radians; a key with a
// suffix from this table ("radius_cm", "zxz_deg") is converted once, when it is read.
#pragma once

#include <string>
#include <vector>

namespace polhode {

enum class Unit {
  none,
  length,            // m
  mass,              // kg
  time,              // s
  angle,             // rad
  angular_velocity,  // rad/s
  angular_momentum,  // kg m^2/s
  inertia,           // kg m^2
  density,           // kg/m^3
  velocity,          // m/s
  acceleration,      // m/s^2
  load,              // N m of a torque, N of a force
};

struct UnitSuffix {
  Unit unit;
  const char* suffix;  // appended to the key; "" is the SI unit itself
  double factor;       // value in SI = value in the file * factor
  const char* symbol;  // for messages and the schema
};

// All suffixes allowed for a quantity of this unit, the SI one first.
std::vector<UnitSuffix> suffixes_of(Unit unit);

// The suffixes of all units, without "".
std::vector<std::string> all_suffixes();

// Converts a value of the file to SI. Decimal prefixes are applied by dividing by a whole number,
// so that 35 cm is exactly the double 0.35.
double to_si(double value, const UnitSuffix& suffix);

// The allowed magnitudes of values of a unit, in SI: wide enough for anything from a molecule to a
// star, but narrow enough that no product of a few such values overflows. `least` bounds values
// that must be positive; other values may be smaller.
struct Magnitude {
  double least;
  double most;
};
// The allowed magnitudes of that unit.
Magnitude magnitude_of(Unit unit);

inline constexpr double kPi = 3.14159265358979323846;

}  // namespace polhode
