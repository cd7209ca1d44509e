// SPDX-License-Identifier: MIT
// The units a scene file may use. Inside the program everything is SI and radians; a key with a
// suffix from this table ("radius_cm", "zxz_deg") is converted once, when it is read.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// The physical quantity of a value, with its SI unit.
enum class Unit {
  none,              // dimensionless
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

// A unit that values of a quantity may be given in, chosen by the suffix of the key.
struct UnitSuffix {
  Unit unit;
  const char* suffix;  // appended to the key, such as "_cm"; "" is the SI unit itself
  double factor;       // value in SI = value in the file * factor
  const char* symbol;  // of the unit, for messages and the schema, such as "cm"
};

// All suffixes allowed for a quantity, that of the SI unit ("") first.
std::vector<UnitSuffix> suffixes_of(Unit unit);

// The suffixes of all quantities, without "".
std::vector<std::string> all_suffixes();

// Converts a value of the file to SI. For factors such as 0.01 it divides by the whole number 100,
// so that the result is rounded once: 35 cm is exactly the double 0.35.
double to_si(double value, const UnitSuffix& suffix);

// The allowed magnitudes of a quantity, in SI units: wide enough for anything from a molecule to a
// star, but narrow enough that no product of a few such values overflows.
struct Magnitude {
  double least;  // of values that must be positive; other values may be smaller, and 0
  double most;   // of the absolute value of all values
};
// The allowed magnitudes of that quantity.
Magnitude magnitude_of(Unit unit);

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kDegree = kPi / 180.0;  // rad

}  // namespace polhode
