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

// Every suffix a quantity of this unit may carry, the SI one first.
std::vector<UnitSuffix> suffixes_of(Unit unit);

// Every suffix there is, "" left out.
std::vector<std::string> all_suffixes();

// A value of the file in SI. Decimal prefixes divide by a whole number, so that 35 cm is 0.35 m to
// the last bit.
double to_si(double value, const UnitSuffix& suffix);

// The sizes, in SI, of the values of this unit that can be computed with: generous for anything
// from a molecule to a star, and small enough that no product of a few of them overflows. What must
// be positive must not be below `least`; for the rest, what is below is nothing.
struct Magnitude {
  double least;
  double most;
};
Magnitude magnitude_of(Unit unit);

inline constexpr double kPi = 3.14159265358979323846;

}  // namespace polhode
