// SPDX-License-Identifier: MIT
// The [motion.friction] table: how a body on a table is held by it.
#pragma once

#include <optional>
#include <string>

#include "base/fields.h"

namespace polhode {

// The table is the plane z = 0 of space.
struct FrictionSpec {
  std::string kind = "coulomb";       // "none", "rolling", "viscous" or "coulomb"
  std::optional<double> mu;           // coulomb: friction over normal force while it slides
  std::optional<double> c;            // viscous: friction over normal force and slip velocity, s/m
  std::optional<double> rolling;      // moment against rolling over normal force, m
  std::optional<double> boring;       // moment against turning about the normal, over it, m
  std::optional<double> restitution;  // speed after over speed before a fall on the table, 0..1
  std::optional<double> turntable;    // angular velocity of the table about Z, rad/s
};

template <class Visitor>
void fields(Visitor& v, FrictionSpec& s) {
  v.field("kind",
          s.kind,
          Doc{"law of friction: none, rolling without slipping, viscous (-c N times the slip "
              "velocity), or coulomb (-mu N against the slip, and sticking)",
              Unit::none,
              kAny,
              {"none", "rolling", "viscous", "coulomb"}});
  v.field("mu", s.mu, Doc{"coulomb: coefficient of friction", Unit::none, kPositive});
  v.field("c",
          s.c,
          Doc{"viscous: friction over normal force and slip velocity, s/m", Unit::none, kPositive});
  v.field("rolling",
          s.rolling,
          Doc{"moment against rolling, over the normal force; absent: none",
              Unit::length,
              kNonNegative});
  v.field("boring",
          s.boring,
          Doc{"moment against turning about the vertical, over the normal force; absent: none",
              Unit::length,
              kNonNegative});
  v.field("restitution",
          s.restitution,
          Doc{"speed after over speed before a fall on the table; with friction, its square is the "
              "part of the work that is given back; absent: 0, it does not bounce",
              Unit::none,
              Range{0.0, 1.0}});
  v.field("turntable",
          s.turntable,
          Doc{"angular velocity of the table about the vertical; absent: it is at rest",
              Unit::angular_velocity});
}

}  // namespace polhode
