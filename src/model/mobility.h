// SPDX-License-Identifier: MIT
// How the point of a body that touches a table answers to forces and impulses there.
#pragma once

#include <algorithm>
#include <cmath>

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
// which the iteration turns towards it; where it turns past it, it is held back, and where it comes
// near, the secant of its last two turns leads on.
template <class Rate>
Vec3 creep_direction(const Vec3& start, double friction, const Rate& rate) {
  constexpr int kMost = 40;
  constexpr double kNear = 0.01, kLeap = 30.0;      // rad, and in turns
  constexpr double kNoTurn = 1e-14, kSame = 1e-11;  // rad
  Vec3 way = start;
  double turn = 2.0, step = 0.0;
  bool follows = false;  // the last turn, with the same friction
  for (int i = 0; i < kMost; ++i) {
    const Vec3 next = friction * way + rate(way);
    const double last = turn;
    turn = std::atan2(way.x() * next.y() - way.y() * next.x(), way.head<2>().dot(next.head<2>()));
    const double size = std::abs(turn);
    if (!(size >= kNoTurn)) break;
    const double slope = follows ? (turn - last) / step : 0.0;
    const bool leads = slope < 0.0 && size < kNear;
    step = leads ? std::clamp(-turn / slope, -kLeap * size, kLeap * size) : turn;
    way = std::cos(step) * way + std::sin(step) * Vec3(-way.y(), way.x(), 0.0);
    if (leads && std::abs(step) < kSame) break;
    follows = size < std::abs(last);
    if (!follows) friction *= 2.0;
  }
  return way;
}

}  // namespace polhode
