// SPDX-License-Identifier: MIT
// The implicit midpoint rule on (y, gamma), with the attitude advanced by the Cayley transform of
// the midpoint angular velocity. It keeps every quadratic invariant: energy, |y|, L in space
// (free), L.up (heavy), whatever the step. Hairer, Lubich, Wanner, GNI, IV.2.1 and VII.5.
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "math/so3.h"
#include "motion/steppers/all.h"
#include "motion/steppers/no_solution.h"

namespace polhode {
namespace {

// solves (1 + [a]x) x = b in closed form
Vec3 solve_one_plus_hat(const Vec3& a, const Vec3& b) {
  return (b - a.cross(b) + a * a.dot(b)) / (1.0 + a.squaredNorm());
}

class ImplicitMidpoint final : public Stepper {
 public:
  explicit ImplicitMidpoint(const BodyModel& model) : model_(model) {}

  void step(double t, double h, State& s, Work& work) const override {
    const Vec3 gamma = up_in_body(model_, s.q);
    const Vec3 middle = solve(t, h, s.y, gamma, work);
    const Vec3 half_turn = 0.5 * h * angular_velocity(model_, middle);
    s.q = normalized(s.q * Quat(1.0, half_turn.x(), half_turn.y(), half_turn.z()));
    s.y = 2.0 * middle - s.y;
  }

 private:
  // Newton's method for the midpoint momentum m:  m = y + h/2 (m x w + gamma_m x chi), where
  // (1 + h/2 [w]x) gamma_m = gamma is the midpoint of gamma turned by the Cayley transform.
  Vec3 solve(double t, double h, const Vec3& y, const Vec3& gamma, Work& work) const {
    const Mat3 inverse = model_.inverse_moments.asDiagonal();
    const double scale = y.norm() + 0.5 * std::abs(h) * model_.chi_P.norm();
    Vec3 m = y;
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      const Vec3 w = angular_velocity(model_, m);
      const Vec3 half_turn = 0.5 * h * w;
      const Vec3 gamma_m = solve_one_plus_hat(half_turn, gamma);
      const Vec3 residual = m - y - 0.5 * h * (m.cross(w) + gamma_m.cross(model_.chi_P));
      ++work.evaluations;

      // d(m x w) = [m]x I^-1 dm - [w]x dm;  d gamma_m = (1 + [a]x)^-1 [gamma_m]x da, a = h/2 I^-1 m
      Mat3 jacobian = Mat3::Identity() - 0.5 * h * (hat(m) * inverse - hat(w));
      if (model_.chi_P.squaredNorm() > 0.0) {
        Mat3 d_gamma;
        const Mat3 right = 0.5 * h * hat(gamma_m) * inverse;
        for (int k = 0; k < 3; ++k)
          d_gamma.col(k) = solve_one_plus_hat(half_turn, right.col(k));
        jacobian += 0.5 * h * hat(model_.chi_P) * d_gamma;
      }
      const Vec3 change = jacobian.partialPivLu().solve(residual);
      m -= change;

      // done when round-off stops the descent
      const double size = change.norm();
      if (size <= 4.0 * std::numeric_limits<double>::epsilon() * scale) return m;
      if (size >= last && size <= 1e-13 * scale) return m;
      if (!std::isfinite(size)) break;
      last = size;
    }
    throw no_solution("implicit_midpoint", t, h, model_, y, "take a step with less than 1");
  }

  static constexpr int kMostIterations = 50;
  BodyModel model_;
};

}  // namespace

std::unique_ptr<Stepper> make_implicit_midpoint(const BodyModel& model, double) {
  return std::make_unique<ImplicitMidpoint>(model);
}

}  // namespace polhode
