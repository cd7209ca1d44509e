// SPDX-License-Identifier: MIT
#include "base/units.h"

#include <cmath>

namespace polhode {
namespace {

// clang-format off
constexpr UnitSuffix kSuffixes[] = {
    {Unit::none,             "",            1.0,          ""},
    {Unit::length,           "",            1.0,          "m"},
    {Unit::length,           "_mm",         1e-3,         "mm"},
    {Unit::length,           "_cm",         1e-2,         "cm"},
    {Unit::length,           "_km",         1e3,          "km"},
    {Unit::mass,             "",            1.0,          "kg"},
    {Unit::mass,             "_g",          1e-3,         "g"},
    {Unit::time,             "",            1.0,          "s"},
    {Unit::time,             "_ms",         1e-3,         "ms"},
    {Unit::time,             "_min",        60.0,         "min"},
    {Unit::time,             "_h",          3600.0,       "h"},
    {Unit::time,             "_d",          86400.0,      "d"},
    {Unit::angle,            "",            1.0,          "rad"},
    {Unit::angle,            "_deg",        kPi / 180.0,  "deg"},
    {Unit::angular_velocity, "",            1.0,          "rad/s"},
    {Unit::angular_velocity, "_deg_per_s",  kPi / 180.0,  "deg/s"},
    {Unit::angular_velocity, "_rpm",        kPi / 30.0,   "rev/min"},
    {Unit::angular_velocity, "_hz",         2.0 * kPi,    "rev/s"},
    {Unit::angular_momentum, "",            1.0,          "kg m^2/s"},
    {Unit::inertia,          "",            1.0,          "kg m^2"},
    {Unit::inertia,          "_g_cm2",      1e-7,         "g cm^2"},
    {Unit::density,          "",            1.0,          "kg/m^3"},
    {Unit::density,          "_g_per_cm3",  1e3,          "g/cm^3"},
    {Unit::velocity,         "",            1.0,          "m/s"},
    {Unit::acceleration,     "",            1.0,          "m/s^2"},
    {Unit::load,             "",            1.0,          "N m or N"},
};
// clang-format on

// classical mechanics ends at the speed of light
struct UnitMagnitude {
  Unit unit;
  Magnitude magnitude;
};
constexpr UnitMagnitude kMagnitudes[] = {
    {Unit::length, {1e-12, 1e15}},
    {Unit::mass, {1e-30, 1e35}},
    {Unit::time, {1e-15, 1e15}},
    {Unit::angle, {1e-100, 1e6}},
    {Unit::angular_velocity, {1e-20, 1e15}},
    {Unit::angular_momentum, {1e-60, 1e60}},
    {Unit::inertia, {1e-54, 1e60}},
    {Unit::density, {1e-20, 1e20}},
    {Unit::velocity, {1e-20, 299792458.0}},
    {Unit::acceleration, {1e-20, 1e15}},
    {Unit::load, {1e-60, 1e60}},
};

}  // namespace

std::vector<UnitSuffix> suffixes_of(Unit unit) {
  std::vector<UnitSuffix> found;
  for (const UnitSuffix& row : kSuffixes) {
    if (row.unit == unit) found.push_back(row);
  }
  return found;
}

std::vector<std::string> all_suffixes() {
  std::vector<std::string> found;
  for (const UnitSuffix& row : kSuffixes) {
    if (*row.suffix != '\0') found.emplace_back(row.suffix);
  }
  return found;
}

double to_si(double value, const UnitSuffix& suffix) {
  // 1e-3 has no exact double, 1000 has: the quotient is rounded once, the product twice
  const double inverse = std::round(1.0 / suffix.factor);
  const bool decimal = suffix.factor < 1.0 && std::abs(inverse * suffix.factor - 1.0) < 1e-12;
  return decimal ? value / inverse : value * suffix.factor;
}

Magnitude magnitude_of(Unit unit) {
  for (const UnitMagnitude& row : kMagnitudes) {
    if (row.unit == unit) return row.magnitude;
  }
  return {1e-100, 1e100};
}

}  // namespace polhode
