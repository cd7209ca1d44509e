// SPDX-License-Identifier: MIT
// How the point of a body that touches a table answers to forces and impulses there.
#pragma once

#include "model/body_model.h"

namespace polhode {

// The velocity of the contact point that a unit impulse there gives, in P, 1/kg. `arm`: from the
// centre of mass to it, P, m.
inline Mat3 mobility(const BodyModel& m, const Vec3& arm) {
  const Vec3& w = m.inverse_moments;
  const Vec3 q = arm.cwiseProduct(arm);
  const double inverse = 1.0 / m.body.mass;
  Mat3 K;
  K(0, 0) = inverse + w.y() * q.z() + w.z() * q.y();
  K(1, 1) = inverse + w.z() * q.x() + w.x() * q.z();
  K(2, 2) = inverse + w.x() * q.y() + w.y() * q.x();
  K(0, 1) = K(1, 0) = -w.z() * arm.x() * arm.y();
  K(1, 2) = K(2, 1) = -w.x() * arm.y() * arm.z();
  K(2, 0) = K(0, 2) = -w.y() * arm.z() * arm.x();
  return K;
}

// The direction along which the slip changes if friction acts against it: rate(u) is along u, up or
// down. `start`: a direction near it; friction: a typical deceleration by friction, m/s^2, with
// which the iteration goes towards it; where it goes past it, it is held back.
template <class Rate>
Vec3 creep_direction(const Vec3& start, double friction, const Rate& rate) {
  constexpr int kMost = 40;
  Vec3 way = start;
  double last = 2.0;
  for (int i = 0; i < kMost; ++i) {
    Vec3 next = friction * way + rate(way);
    next.z() = 0.0;
    const double size = next.norm();
    if (!(size > 0.0)) break;
    next /= size;
    const double apart = (next - way).norm();
    way = next;
    if (apart < 1e-14) break;
    if (apart >= last) friction *= 2.0;
    last = apart;
  }
  return way;
}

}  // namespace polhode
