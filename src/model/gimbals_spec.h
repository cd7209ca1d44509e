// SPDX-License-Identifier: MIT
// The [motion.gimbals] table: two rings that carry a body on a pivot.
#pragma once

#include <optional>
#include <string>

#include "base/fields.h"
#include "math/notation.h"

namespace polhode {

// The outer ring turns about the vertical, the inner one in it about the line of nodes, and the
// body in that about its axle, which is its axis of symmetry, else its z axis.
struct GimbalsSpec {
  double outer = 0.0;            // moment of the outer ring about the vertical, kg m^2
  Vec3 inner = Vec3::Zero();     // moments of the inner ring about the line of nodes, about the
                                 // line across it and the axle, and about the axle, kg m^2
  Vec3 friction = Vec3::Zero();  // torque over rate in the bearings of the outer ring, the inner
                                 // ring and the axle, N m s
  std::optional<std::string> clamp;  // "outer" or "inner": this ring does not turn in its bearings
};

template <class Visitor>
void fields(Visitor& v, GimbalsSpec& s) {
  v.field(
      "outer",
      s.outer,
      Doc{"moment of inertia of the outer ring about the vertical", Unit::inertia, kNonNegative});
  v.field("inner",
          s.inner,
          Doc{"moments of inertia of the inner ring about the line of nodes, across, and about the "
              "axle",
              Unit::inertia,
              kNonNegative});
  v.field(
      "friction",
      s.friction,
      Doc{"torque over angular velocity, N m s, in the bearings of the outer ring, of the inner "
          "ring and of the axle",
          Unit::none,
          kNonNegative});
  v.field(
      "clamp",
      s.clamp,
      Doc{"the ring that does not turn: \"inner\" keeps the tilt of the axle, \"outer\" the plane "
          "in which it tilts",
          Unit::none,
          kAny,
          {"outer", "inner"}});
}

}  // namespace polhode
