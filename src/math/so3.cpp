// SPDX-License-Identifier: MIT
#include "math/so3.h"

#include <cmath>
#include <limits>

namespace polhode {

Quat exp_rotation(const Vec3& v) {
  const double half = 0.5 * v.norm();
  // sin(x)/x loses nothing above this; below it the series is exact to round-off
  const double sinc = half > 1e-4 ? std::sin(half) / half : 1.0 - half * half / 6.0;
  const Vec3 axis = 0.5 * sinc * v;
  return {std::cos(half), axis.x(), axis.y(), axis.z()};
}

double rotation_angle_between(const Quat& a, const Quat& b) {
  const Quat between = a.conjugate() * b;
  return 2.0 * std::atan2(between.vec().norm(), std::abs(between.w()));
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b) + 0.0);  // -0 would make it pi
}

Quat turn_between(const Vec3& from, const Vec3& to) {
  return Quat::FromTwoVectors(from, to);
}

Vec3 zxz_angles(const Quat& q) {
  // q = z(phi) x(theta) z(psi): (w, z) carry cos(theta/2) and phi + psi, (x, y) sin(theta/2) and
  // phi - psi
  const double cos_half = std::hypot(q.w(), q.z());
  const double sin_half = std::hypot(q.x(), q.y());
  const double theta = 2.0 * std::atan2(sin_half, cos_half);
  const double half_sum = std::atan2(q.z(), q.w());
  const double half_difference = std::atan2(q.y(), q.x());
  if (sin_half == 0.0) return {2.0 * half_sum, theta, 0.0};
  if (cos_half == 0.0) return {2.0 * half_difference, theta, 0.0};
  return {half_sum + half_difference, theta, half_sum - half_difference};
}

Quat from_zxz_angles(const Vec3& angles) {
  return exp_rotation(angles[0] * Vec3::UnitZ()) * exp_rotation(angles[1] * Vec3::UnitX()) *
         exp_rotation(angles[2] * Vec3::UnitZ());
}

Vec3 body_rate_from_zxz_rates(const Vec3& angles, const Vec3& rates) {
  const double sin_theta = std::sin(angles[1]);
  const double sin_psi = std::sin(angles[2]);
  const double cos_psi = std::cos(angles[2]);
  return {rates[0] * sin_theta * sin_psi + rates[1] * cos_psi,
          rates[0] * sin_theta * cos_psi - rates[1] * sin_psi,
          rates[0] * std::cos(angles[1]) + rates[2]};
}

Vec3 zxz_rates_from_body_rate(const Vec3& angles, const Vec3& w_B) {
  const double sin_theta = std::sin(angles[1]);
  const double sin_psi = std::sin(angles[2]);
  const double cos_psi = std::cos(angles[2]);
  const double first = sin_theta == 0.0 ? std::numeric_limits<double>::quiet_NaN()
                                        : (w_B[0] * sin_psi + w_B[1] * cos_psi) / sin_theta;
  return {first, w_B[0] * cos_psi - w_B[1] * sin_psi, w_B[2] - first * std::cos(angles[1])};
}

Mat3 from_xyz_turns(const Vec3& turns) {
  return (exp_rotation(turns[2] * Vec3::UnitZ()) * exp_rotation(turns[1] * Vec3::UnitY()) *
          exp_rotation(turns[0] * Vec3::UnitX()))
      .toRotationMatrix();
}

Quat normalized(const Quat& q) {
  return Quat(q.coeffs() / q.coeffs().norm());
}

}  // namespace polhode
