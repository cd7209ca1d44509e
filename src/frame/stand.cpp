// SPDX-License-Identifier: MIT
#include "frame/stand.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "base/units.h"

namespace polhode {
namespace {

// sizes in units of the body's radius; depths are below the pivot
constexpr double kBearingRadius = 0.028;
constexpr double kBearingDepth = 0.1;  // of its centre
constexpr double kPinRadius = 0.012;   // where the pin leaves the ball
constexpr double kSeatRadius = 0.02;   // where the ball leaves its seat

// the ball, from its seat round to the pin
void add_bearing(std::vector<Vec2>& outline, int pieces) {
  const double from = -std::acos(kSeatRadius / kBearingRadius);
  const double to = std::acos(kPinRadius / kBearingRadius);
  for (int i = 0; i <= pieces; ++i) {
    const double angle = from + (to - from) * i / pieces;
    outline.emplace_back(kBearingRadius * std::cos(angle),
                         kBearingRadius * std::sin(angle) - kBearingDepth);
  }
}

}  // namespace

Mesh stand_mesh(double height, int segments) {
  CHECK(height >= 0.4);
  const double foot = -height;
  // clang-format off
  std::vector<Vec2> outline = {
      {0.0, foot}, {kStandFoot, foot},                            // base plate
      {kStandFoot, foot + 0.022}, {kStandFoot - 0.008, foot + 0.030},
      {0.075, foot + 0.034}, {0.055, foot + 0.041},               // rounded into the column
      {0.044, foot + 0.054}, {0.039, foot + 0.075},
      {0.022, -0.165}, {0.034, -0.150}, {0.034, -0.128},          // collar
      {0.030, -0.122}};                                           // seat of the ball
  // clang-format on
  add_bearing(outline, std::max(6, segments / 6));
  outline.emplace_back(0.0, 0.0);
  return revolved(outline, segments);
}

}  // namespace polhode
