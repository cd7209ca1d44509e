// SPDX-License-Identifier: MIT
// Rotations: exponential map, Euler angles, distance; angles between directions.
#pragma once

#include "math/notation.h"

namespace polhode {

// The rotation by |v| radians about v. Exact to round-off for every |v|, zero included.
Quat exp_rotation(const Vec3& v);

// Angle in radians, 0..pi, of the rotation that takes one attitude into the other. Keeps its digits
// for tiny angles (uses the vector part, not acos of the scalar part).
double rotation_angle_between(const Quat& a, const Quat& b);

// Angle in radians, 0..pi, between two directions of any length. Keeps its digits near 0 and pi,
// where acos of the scalar product has none left; 0 if either is zero.
double angle_between(const Vec3& a, const Vec3& b);

// The least rotation that takes the direction of `from` into that of `to`, neither of them zero;
// for opposite directions half a turn about an axis square to both. Eigen's, instantiated once: it
// costs a compiler five seconds.
Quat turn_between(const Vec3& from, const Vec3& to);

// zxz Euler angles (phi, theta, psi) in radians, 0 <= theta <= pi; at the poles psi = 0.
Vec3 zxz_angles(const Quat& q);
Quat from_zxz_angles(const Vec3& angles);

// Angular velocity in body axes from the rates of the zxz angles
// (Landau and Lifshitz, Mechanics, eq. 35.1, whose third line is the figure axis here too).
Vec3 body_rate_from_zxz_rates(const Vec3& angles, const Vec3& rates);

// R = Rz(c) Ry(b) Rx(a): turn about x, then y, then z of the fixed axes, radians.
Mat3 from_xyz_turns(const Vec3& turns);

// The matrix of the cross product: hat(a) b = a x b.
inline Mat3 hat(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// q scaled to unit length; used after steps that leave the sphere.
Quat normalized(const Quat& q);

}  // namespace polhode
