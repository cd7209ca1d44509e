// SPDX-License-Identifier: MIT
// Random bodies of point masses, the same on every machine, for checking formulas against sums.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "model/rigid_body.h"

namespace polhode::test {

// Uniform numbers in -1..1 from a seed; std::mt19937_64 is the same everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double number() { return std::ldexp(static_cast<double>(engine_() >> 11), -52) - 1.0; }
  Vec3 vector() {
    const double x = number();
    const double y = number();
    const double z = number();
    return {x, y, z};
  }

 private:
  std::mt19937_64 engine_;
};

// A body of point masses in motion: its origin moves with V, it turns with Omega.
struct Particles {
  std::vector<PointMass> points;  // from the origin
  Vec3 V, Omega;

  Vec3 velocity(const PointMass& p) const { return V + Omega.cross(p.at); }
  // Sum of term(particle) over all of them.
  template <class Term>
  auto sum(const Term& term) const {
    auto total = term(points.front());
    for (std::size_t i = 1; i < points.size(); ++i)
      total += term(points[i]);
    return total;
  }
  double mass() const {
    return sum([](const PointMass& p) { return p.mass; });
  }
  Vec3 first_moment() const {
    return sum([](const PointMass& p) { return Vec3(p.mass * p.at); });
  }
  // Inertia tensor about the origin, by the definition written out.
  Mat3 tensor() const {
    return sum([](const PointMass& p) {
      const Vec3& r = p.at;
      Mat3 t;
      t << r.y() * r.y() + r.z() * r.z(), -r.x() * r.y(), -r.x() * r.z(),  //
          -r.y() * r.x(), r.x() * r.x() + r.z() * r.z(), -r.y() * r.z(),   //
          -r.z() * r.x(), -r.z() * r.y(), r.x() * r.x() + r.y() * r.y();
      return Mat3(p.mass * t);
    });
  }
  // Sum of m v^2 / 2, J.
  double energy() const {
    return sum([&](const PointMass& p) { return 0.5 * p.mass * velocity(p).squaredNorm(); });
  }
};

// Twelve masses, the origin anywhere.
inline Particles random_particles(std::uint64_t seed) {
  Dice dice(seed);
  Particles body;
  for (int i = 0; i < 12; ++i) {
    const double mass = 0.2 + 0.1 * (dice.number() + 1.0);
    body.points.push_back({mass, dice.vector()});
  }
  body.V = dice.vector();
  body.Omega = dice.vector();
  return body;
}

// The same with the origin at the centre of mass.
inline Particles random_centered_particles(std::uint64_t seed) {
  Particles body = random_particles(seed);
  const Vec3 center = body.first_moment() / body.mass();
  for (PointMass& p : body.points)
    p.at -= center;
  return body;
}

}  // namespace polhode::test
