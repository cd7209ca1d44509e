// SPDX-License-Identifier: MIT
// The motion of a free body over a time h, exact to round-off and cheap to restart at every step.
// The kick methods are built from it.
#pragma once

#include "model/body_model.h"

namespace polhode {

// Spherical and symmetric bodies (rotators too) use their closed form. Asymmetric ones use the
// Taylor series of Euler's equations and get the attitude from one more quadrature: in q = q0 o
// p0^-1 o exp(psi e) o p, where p (p0 at the start) is the smallest rotation that takes the
// momentum to the principal axis e (moment I) closest to it at the start,
//   dpsi/dt = |y| / I + (2 T - |y|^2 / I) / (|y| + y.e),   T the kinetic energy,
// (from w = dpsi/dt y/|y| + w_p, with w_p the angular velocity of p; compare van Zon and Schofield,
// J. Comput. Phys. 225 (2007) 145, section 2). If the body could turn by more than 8 rad (|h| |y| /
// least moment), they use their closed form. Gravity and loads are ignored. Immutable, so any
// thread may use it.
class FreeFlow {
 public:
  // Copies what it needs of the model.
  explicit FreeFlow(const BodyModel& model);

  // Advances attitude q (P to S) and momentum y (in P, kg m^2/s) by h (s), of any sign and length.
  // q stays of unit length to round-off.
  void operator()(double h, Quat& q, Vec3& y) const {
    if (asymmetric_) {
      by_series_or_closed_form(h, q, y);
    } else {
      by_turns(h, q, y);
    }
  }

 private:
  Vec3 inverse_;  // 1 / moments
  bool asymmetric_;
  int axis_;           // of symmetry
  double across_;      // 1 / moment across that axis
  double difference_;  // 1 / moment along it, less across_
  BodyModel free_;     // the body without gravity, for the closed form
  Vec3 gyration_;      // dy_i/dt = gyration_i y_j y_k

  void by_turns(double h, Quat& q, Vec3& y) const;
  void by_series_or_closed_form(double h, Quat& q, Vec3& y) const;
  void series_step(double h, Quat& q, Vec3& y) const;
};

}  // namespace polhode
