// SPDX-License-Identifier: MIT
#include "base/units.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace polhode {
namespace {

constexpr Unit kUnits[] = {Unit::none,
                           Unit::length,
                           Unit::mass,
                           Unit::time,
                           Unit::angle,
                           Unit::angular_velocity,
                           Unit::inertia,
                           Unit::angular_momentum,
                           Unit::density,
                           Unit::velocity,
                           Unit::acceleration};

// the suffix of a unit, which must exist
UnitSuffix suffix(Unit unit, const std::string& name) {
  for (const UnitSuffix& row : suffixes_of(unit)) {
    if (row.suffix == name) return row;
  }
  ADD_FAILURE() << name;
  return {};
}

TEST(Units, EveryUnitHasSiFirstAndNoSuffixTwice) {
  for (const Unit unit : kUnits) {
    const std::vector<UnitSuffix> suffixes = suffixes_of(unit);
    ASSERT_FALSE(suffixes.empty());
    EXPECT_STREQ(suffixes.front().suffix, "");
    EXPECT_EQ(suffixes.front().factor, 1.0);
    std::set<std::string> names;
    for (const UnitSuffix& row : suffixes) {
      EXPECT_TRUE(names.insert(row.suffix).second) << row.suffix;
      EXPECT_GT(row.factor, 0.0);
    }
  }
}

TEST(Units, DecimalUnitsAreExact) {
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(to_si(i, suffix(Unit::length, "_cm")), i / 100.0);
    EXPECT_EQ(to_si(i, suffix(Unit::length, "_mm")), i / 1000.0);
    EXPECT_EQ(to_si(i, suffix(Unit::mass, "_g")), i / 1000.0);
    EXPECT_EQ(to_si(i, suffix(Unit::inertia, "_g_cm2")), i / 1e7);
  }
}

TEST(Units, FactorsAreRight) {
  EXPECT_EQ(to_si(2, suffix(Unit::length, "_km")), 2000.0);
  EXPECT_EQ(to_si(1, suffix(Unit::time, "_d")), 86400.0);
  EXPECT_EQ(to_si(2.7, suffix(Unit::density, "_g_per_cm3")), 2700.0);
  EXPECT_DOUBLE_EQ(to_si(180, suffix(Unit::angle, "_deg")), kPi);
  EXPECT_DOUBLE_EQ(to_si(60, suffix(Unit::angular_velocity, "_rpm")), 2 * kPi);
  EXPECT_DOUBLE_EQ(to_si(90, suffix(Unit::angular_velocity, "_deg_per_s")), kPi / 2);
}

TEST(Units, KeepInfinityAndSign) {
  EXPECT_TRUE(std::isinf(to_si(1e308, suffix(Unit::time, "_d"))));
  EXPECT_EQ(to_si(-35, suffix(Unit::length, "_cm")), -0.35);
}

}  // namespace
}  // namespace polhode
