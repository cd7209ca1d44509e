// SPDX-License-Identifier: MIT
#include "frame/coil.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"

namespace polhode {
namespace {

constexpr double kRadius = 0.1, kEnd = 0.15;

// the angle about z through which a line turns, summed over its pieces away from the axis, rad
double turned(const std::vector<Vec3>& line) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 a = line[i].head<2>(), b = line[i + 1].head<2>();
    if (std::min(a.norm(), b.norm()) < 1e-9) continue;
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return sum;
}

// whatever its length, a coil has the same ends, turns and radius
TEST(Coil, StretchingChangesOnlyThePitch) {
  constexpr int kPieces = 20;
  for (const double length : {0.0, 1e-12, 0.01, 0.4, 3.0, 500.0}) {
    SCOPED_TRACE(length);
    const std::vector<Vec3> line = coil_line(length, kRadius, kEnd, kPieces);
    EXPECT_EQ(line.front(), Vec3::Zero());
    EXPECT_EQ(line.back(), Vec3(0, 0, length));
    // the first and the last piece of the helix begin and end on the axis
    const double missed = 2.0 / kPieces;
    EXPECT_NEAR(turned(line) / (2.0 * kPi), kCoilTurns - missed, 1e-9);
    double widest = 0.0;
    for (const Vec3& point : line) {
      EXPECT_GE(point.z(), 0.0);
      EXPECT_LE(point.z(), length);
      widest = std::max(widest, point.head<2>().norm());
    }
    EXPECT_NEAR(widest, kRadius, 1e-15);
  }
}

// all but the first and the last half turn is a helix of constant pitch
TEST(Coil, BetweenItsEndsItIsAHelix) {
  constexpr int kPieces = 16;
  const double length = 2.0;
  const std::vector<Vec3> line = coil_line(length, kRadius, kEnd, kPieces);
  const double pitch = (length - 2.0 * kEnd) / kCoilTurns;
  for (int i = kPieces / 2; i <= (kCoilTurns - 1) * kPieces - kPieces / 2; ++i) {
    const Vec3& here = line[static_cast<std::size_t>(1 + i)];
    const Vec3& a_turn_on = line[static_cast<std::size_t>(1 + i + kPieces)];
    EXPECT_NEAR(here.head<2>().norm(), kRadius, 1e-15);
    EXPECT_LT((a_turn_on - here - Vec3(0, 0, pitch)).norm(), 1e-12);
  }
}

// straight ends, at most a tenth of the length each
TEST(Coil, EndsAreStraight) {
  for (const double length : {0.5, 4.0}) {
    const std::vector<Vec3> line = coil_line(length, kRadius, kEnd, 12);
    const double straight = std::min(kEnd, 0.1 * length);
    EXPECT_LT((line[1] - Vec3(0, 0, straight)).norm(), 1e-12);
    EXPECT_LT((line[line.size() - 2] - Vec3(0, 0, length - straight)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace polhode
