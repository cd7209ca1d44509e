// SPDX-License-Identifier: MIT
#include "frame/coil.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "frame/timeline.h"

namespace polhode {
namespace {

constexpr double kMostOfEnd = 0.1;      // of the length of a coil
constexpr double kTurnsOutwards = 0.5;  // in which the radius grows from zero

}  // namespace

std::vector<Vec3> coil_line(double length, double radius, double end, int pieces) {
  const double straight = std::min(end, kMostOfEnd * length);
  const int steps = kCoilTurns * pieces;
  std::vector<Vec3> line = {Vec3::Zero()};
  for (int i = 0; i <= steps; ++i) {
    const double turns = static_cast<double>(i) / pieces;
    const double r = radius * eased(std::min(turns, kCoilTurns - turns) / kTurnsOutwards);
    const double angle = 2.0 * kPi * turns;
    const double z = straight + (length - 2.0 * straight) * i / steps;
    line.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  line.emplace_back(0.0, 0.0, length);
  return line;
}

}  // namespace polhode
