// SPDX-License-Identifier: MIT
// What game engines step rigid bodies with, kept to show how it fails: all of first order.
#include <cmath>

#include <Eigen/LU>

#include "math/so3.h"
#include "motion/steppers/all.h"

namespace polhode {
namespace {

// dq/dt with the new angular velocity, and back to unit length
Quat turned(const Quat& q, const Vec3& w_P, double h) {
  const Quat rate = attitude_rate(q, w_P);
  return normalized(Quat(Eigen::Vector4d(q.coeffs() + h * rate.coeffs())));
}

// Momentum first, with the gyroscopic torque of the old one; attitude with the new one.
class SemiImplicitEuler final : public Stepper {
 public:
  explicit SemiImplicitEuler(const Model& model) : model_(model) {}

  void step(double, double h, State& s) override {
    s.y += h * momentum_rate(model_, s.y, up_in_body(model_, s.q));
    s.q = turned(s.q, angular_velocity(model_, s.y), h);
    ++evaluations_;
  }

 private:
  Model model_;
};

// One Newton step for I (w' - w) + h w' x I w' = h torque (Catto, GDC 2015). In momenta, so that a
// rotator's missing moment is never divided by: (1 + h ([w]x - [y]x I^-1)) (y' - y) = h (y x w +
// torque).
class LinearlyImplicitEuler final : public Stepper {
 public:
  explicit LinearlyImplicitEuler(const Model& model) : model_(model) {}

  void step(double, double h, State& s) override {
    const Vec3 w = angular_velocity(model_, s.y);
    const Mat3 inverse = model_.inverse_moments.asDiagonal();
    const Mat3 jacobian = Mat3::Identity() + h * (hat(w) - hat(s.y) * inverse);
    const Vec3 rate = momentum_rate(model_, s.y, up_in_body(model_, s.q));
    s.y += jacobian.partialPivLu().solve(h * rate);
    s.q = turned(s.q, angular_velocity(model_, s.y), h);
    ++evaluations_;
  }

 private:
  Model model_;
};

// The gyroscopic torque of the old momentum, |y| set back to what it was, then the torque (Jolt,
// Avian).
class RenormalisedExplicit final : public Stepper {
 public:
  explicit RenormalisedExplicit(const Model& model) : model_(model) {}

  void step(double, double h, State& s) override {
    const double norm = s.y.norm();
    const Vec3 turned_y = s.y + h * s.y.cross(angular_velocity(model_, s.y));
    if (norm > 0.0) s.y = turned_y * (norm / turned_y.norm());
    s.y += h * up_in_body(model_, s.q).cross(model_.chi_P);
    s.q = turned(s.q, angular_velocity(model_, s.y), h);
    ++evaluations_;
  }

 private:
  Model model_;
};

}  // namespace

std::unique_ptr<Stepper> make_semi_implicit_euler(const Model& model, double) {
  return std::make_unique<SemiImplicitEuler>(model);
}

std::unique_ptr<Stepper> make_linearly_implicit_euler(const Model& model, double) {
  return std::make_unique<LinearlyImplicitEuler>(model);
}

std::unique_ptr<Stepper> make_renormalised_explicit(const Model& model, double) {
  return std::make_unique<RenormalisedExplicit>(model);
}

}  // namespace polhode
