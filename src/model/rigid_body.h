// SPDX-License-Identifier: MIT
// Kinematics and energy of a rigid body about any origin: the formulas of the lecture notes, with
// misprints corrected (docs/theory.md). Vectors of one call are all in the same axes.
#pragma once

#include <vector>

#include "math/notation.h"
#include "model/mass_properties.h"

namespace polhode {

// Velocity (m/s) of the body's point at `r` (m) from an origin that moves with V (m/s), while the
// body turns with Omega (rad/s); all in the same axes (notes eq. 2): V + Omega x r.
Vec3 point_velocity(const Vec3& V, const Vec3& Omega, const Vec3& r);

// Sum of m (s^2 1 - s s^T) with s = r - origin, kg m^2: the inertia tensor of point masses about
// any origin (m) (notes eqs. 6 and 8; the printed element yz of eq. 8 repeats xz).
Mat3 inertia_tensor(const std::vector<PointMass>& points, const Vec3& origin);

// A tensor carried from origin O to O + a, where O need not be the centre of mass (notes eq. 11,
// whose printed middle term has the wrong sign and lacks its transposed part):
//   I - sum m (2 (r.a) 1 - r a^T - a r^T) + sum m (a^2 1 - a a^T).
// first_moment is sum m r about O, kg m. It is zero about the centre of mass, which leaves eq. 12.
Mat3 tensor_with_origin_moved(const Mat3& tensor,
                              double mass,
                              const Vec3& first_moment,
                              const Vec3& a);

// Angular momentum L = I Omega about the point of the tensor, kg m^2/s (notes eq. 14). It is the
// whole angular momentum about a fixed point or the centre of mass, but only its spin part about a
// moving point.
Vec3 angular_momentum(const Mat3& tensor, const Vec3& Omega);

// Kinetic energy in J, split as in notes eq. 4, with the factor 1/2 that is missing in print. M:
// mass; V: velocity of the chosen point; c: vector from there to the centre of mass.
struct KineticEnergy {
  double translation = 0.0;  // M V^2 / 2
  double rotation = 0.0;     // Omega . I Omega / 2
  double coupling = 0.0;     // M V . (Omega x c); 0 if the point is the centre of mass

  double total() const { return translation + rotation + coupling; }
};

// Kinetic energy of a body whose point `origin` (m) moves with V (m/s) while the body turns with
// Omega (rad/s); all in the axes of `body`.
KineticEnergy kinetic_energy(const MassProperties& body,
                             const Vec3& origin,
                             const Vec3& V,
                             const Vec3& Omega);

}  // namespace polhode
