// SPDX-License-Identifier: MIT
// The state as a vector of seven numbers, for the Runge-Kutta methods.
#pragma once

#include "math/so3.h"
#include "model/model.h"

namespace polhode {

// (q.x, q.y, q.z, q.w, y1, y2, y3)
using Vec7 = Eigen::Matrix<double, 7, 1>;

inline Vec7 to_vector(const State& s) {
  Vec7 v;
  v << s.q.coeffs(), s.y;
  return v;
}

// The attitude is scaled back to unit length.
inline State to_state(const Vec7& v) {
  return {normalized(Quat(Eigen::Vector4d(v.head<4>()))), v.tail<3>()};
}

// The right-hand side. Stages leave the unit sphere by the order of the step; gravity is seen
// through q as it is, so that the vector field is smooth and the order of the method is kept.
inline Vec7 derivative(const Model& m, const Vec7& v) {
  const Quat q(Eigen::Vector4d(v.head<4>()));
  const Vec3 y = v.tail<3>();
  Vec7 rate;
  rate << attitude_rate(q, angular_velocity(m, y)).coeffs(), momentum_rate(m, y, up_in_body(m, q));
  return rate;
}

}  // namespace polhode
