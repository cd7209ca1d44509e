// SPDX-License-Identifier: MIT
// Rotations: exponential map, Euler angles, angular distances.
#pragma once

#include "math/notation.h"

namespace polhode {

// The rotation by |v| radians about v. Accurate to round-off for every v, including zero.
Quat exp_rotation(const Vec3& v);

// Angle in radians, 0..pi, of the rotation from one attitude (unit quaternion) to the other.
// Accurate for tiny angles too, because it uses the vector part and not acos of the scalar part.
double rotation_angle_between(const Quat& a, const Quat& b);

// Angle in radians, 0..pi, between two vectors of any length; 0 if either is zero. Accurate near 0
// and pi too, where acos of the scalar product is not.
double angle_between(const Vec3& a, const Vec3& b);

// The smallest rotation that takes the direction of `from` to that of `to`; neither may be zero.
// For opposite directions it is half a turn about an axis perpendicular to both. Wraps Eigen's
// FromTwoVectors, whose template takes five seconds to compile, so that it is instantiated once.
Quat turn_between(const Vec3& from, const Vec3& to);

// zxz Euler angles (phi, theta, psi) in radians, with 0 <= theta <= pi; psi = 0 where theta is 0 or
// pi. phi and psi are within [-2 pi, 2 pi].
Vec3 zxz_angles(const Quat& q);
// The rotation Rz(phi) Rx(theta) Rz(psi), angles in radians.
Quat from_zxz_angles(const Vec3& angles);

// Angular velocity in body axes B (rad/s) from the zxz angles (rad) and their rates (rad/s): Landau
// and Lifshitz, Mechanics, eq. 35.1.
Vec3 body_rate_from_zxz_rates(const Vec3& angles, const Vec3& rates);

// The inverse. Where sin(theta) is 0, the first and the third rate are NaN.
Vec3 zxz_rates_from_body_rate(const Vec3& angles, const Vec3& w_B);

// R = Rz(c) Ry(b) Rx(a) for turns = (a, b, c) in radians: a turn about x, then y, then z of the
// fixed axes.
Mat3 from_xyz_turns(const Vec3& turns);

// The matrix of the cross product: hat(a) b = a x b.
inline Mat3 hat(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// q, which must not be zero, scaled to unit length: for steps that leave the unit sphere.
Quat normalized(const Quat& q);

}  // namespace polhode
