// SPDX-License-Identifier: MIT
// The `torque` list of a [motion] table: torques and forces that act besides gravity.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "math/notation.h"

namespace polhode {

// One load. load_kinds() (model/loads.h) says which of the keys a kind needs and takes; the others
// must stay empty.
struct LoadSpec {
  std::string kind;               // a name from load_kinds()
  std::optional<Vec3> space;      // torque or force in space axes, N m or N
  std::optional<Vec3> body;       // the same in body axes
  std::optional<Vec3> at;         // point of action, from the body origin in B, m; absent:
                                  // the centre of mass
  std::optional<Vec3> opposite;   // where the opposite force of a couple acts, in B, m
  std::optional<Vec3> to;         // the end of a spring that is fixed in space, in S, m;
                                  // absent: the origin
  std::optional<double> k;        // stiffness of a spring, N/m
  std::optional<double> length;   // length of an unstretched spring, m; absent: 0
  std::optional<double> c;        // damping coefficient, see `of`
  std::optional<std::string> of;  // damping -c L ("momentum", c in 1/s; also if absent) or
                                  // -c omega ("spin", c in N m s)
  std::optional<Vec3> about;      // of damping of spin: the only axis about which it acts, as of a
                                  // bearing, in B
  std::optional<double> rate;     // the load varies as cos(rate t + phase), rad/s; absent: 0; of a
                                  // gravity gradient: angular velocity of the orbit
  std::optional<double> phase;    // rad; absent: 0
  std::optional<double> from;     // when it begins, s; absent: it acts from the start
  std::optional<double> until;    // when it begins to end, s; absent: never
  std::optional<double> ramp;     // how long it takes to rise and to fall, s; absent: no time
};

// The names in load_kinds(), for help and the schema.
std::vector<std::string> load_names();

template <class Visitor>
void fields(Visitor& v, LoadSpec& s) {
  v.required("kind", s.kind, Doc{"kind of load", Unit::none, kAny, load_names()});
  v.at_most_one_of({"space", "body"});
  v.field("space", s.space, Doc{"torque (N m) or force (N) in space axes", Unit::load});
  v.field("body", s.body, Doc{"torque (N m) or force (N) in body axes", Unit::load});
  v.field("at",
          s.at,
          Doc{"point of action of the force, in body coordinates; absent: the centre of mass",
              Unit::length});
  v.field(
      "opposite",
      s.opposite,
      Doc{"point of action of the opposite force of a couple, in body coordinates", Unit::length});
  v.field("to",
          s.to,
          Doc{"the end of a spring that is fixed in space; absent: the origin", Unit::length});
  v.field("k", s.k, Doc{"stiffness of a spring, N/m", Unit::none, kPositive});
  v.field("length", s.length, Doc{"length of the unstretched spring", Unit::length, kNonNegative});
  v.field("c",
          s.c,
          Doc{"damping coefficient: 1/s for \"momentum\", N m s for \"spin\"",
              Unit::none,
              kNonNegative});
  v.field("of",
          s.of,
          Doc{"torque of damping: -c L (\"momentum\") or -c omega (\"spin\")",
              Unit::none,
              kAny,
              {"momentum", "spin"}});
  v.field("about",
          s.about,
          Doc{"axis of the bearing that damps the spin, in body axes; absent: any spin is damped"});
  v.field("rate",
          s.rate,
          Doc{"angular frequency of a load that swings as cos(rate t + phase); absent: 0; of a "
              "gravity gradient, the angular velocity of the orbit",
              Unit::angular_velocity});
  v.field("phase",
          s.phase,
          Doc{"phase at t = 0 of a load that swings as cos(rate t + phase), or of an orbit from X "
              "towards Y; absent: 0",
              Unit::angle});
  v.field("from",
          s.from,
          Doc{"when the load begins; absent: it acts from the start", Unit::time, kNonNegative});
  v.field("until",
          s.until,
          Doc{"when the load ends, or begins to fall; absent: never", Unit::time, kNonNegative});
  v.field("ramp",
          s.ramp,
          Doc{"how long the load takes to rise after `from`, and to fall after `until`; absent: no "
              "time",
              Unit::time,
              kNonNegative});
}

}  // namespace polhode
