// SPDX-License-Identifier: MIT
// Rotations for the splitting methods, inline and without library calls for the small angles of a
// step. Angles are in radians.
#pragma once

#include <cmath>

#include "math/notation.h"

namespace polhode {

// cos(x), sin(x) and sin(x)/x of half an angle x.
struct HalfTurn {
  double cosine, sine, sinc;  // sinc is sin(x)/x
};

// For a half angle x with x2 = x^2 <= 1/4: Taylor series, exact to round-off.
inline HalfTurn small_half_turn(double x2, double x) {
  const double sinc =
      1.0 - x2 / 6.0 *
                (1.0 - x2 / 20.0 *
                           (1.0 - x2 / 42.0 *
                                      (1.0 - x2 / 72.0 * (1.0 - x2 / 110.0 * (1.0 - x2 / 156.0)))));
  const double cosine =
      1.0 -
      x2 / 2.0 *
          (1.0 -
           x2 / 12.0 *
               (1.0 - x2 / 30.0 *
                          (1.0 - x2 / 56.0 *
                                     (1.0 - x2 / 90.0 * (1.0 - x2 / 132.0 * (1.0 - x2 / 182.0))))));
  return {cosine, x * sinc, sinc};
}

// For an angle of any size.
inline HalfTurn half_turn(double angle) {
  const double x = 0.5 * angle;
  if (x * x <= 0.25) return small_half_turn(x * x, x);
  return {std::cos(x), std::sin(x), std::sin(x) / x};
}

// exp(v): the rotation by |v| radians about v.
inline Quat turn_by(const Vec3& v) {
  const double x2 = 0.25 * v.squaredNorm();
  const double x = std::sqrt(x2);
  const HalfTurn half =
      x2 <= 0.25 ? small_half_turn(x2, x) : HalfTurn{std::cos(x), std::sin(x), std::sin(x) / x};
  const Vec3 axis = 0.5 * half.sinc * v;
  return {half.cosine, axis.x(), axis.y(), axis.z()};
}

// Turns the body by `angle` about its principal axis k (0..2) while its momentum stays constant in
// space: q <- q o exp(angle e_k), y <- exp(-angle e_k) y. q: attitude (P to S); y: momentum in P.
inline void turn_about_axis(int k, double angle, Quat& q, Vec3& y) {
  const int i = k == 2 ? 0 : k + 1;
  const int j = k == 0 ? 2 : k - 1;
  const HalfTurn half = half_turn(angle);
  const double c = half.cosine, s = half.sine;
  Eigen::Vector4d& v = q.coeffs();
  const double vi = v[i] * c + v[j] * s;
  const double vj = v[j] * c - v[i] * s;
  const double vk = v[k] * c + v[3] * s;
  v[3] = v[3] * c - v[k] * s;
  v[i] = vi, v[j] = vj, v[k] = vk;
  const double sine = 2.0 * s * c;
  const double one_less_cosine = 2.0 * s * s;
  const double yi = y[i], yj = y[j];
  y[i] = yi - (yi * one_less_cosine - yj * sine);
  y[j] = yj - (yj * one_less_cosine + yi * sine);
}

// Normalises a quaternion whose length differs from 1 by round-off only.
inline void trim(Quat& q) {
  q.coeffs() *= 1.5 - 0.5 * q.squaredNorm();
}

}  // namespace polhode
