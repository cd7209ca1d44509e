// SPDX-License-Identifier: MIT
// First-order steps that physics engines take for the gyroscopic torque: first the angular
// velocity, then the attitude by the new one. Kept to show what each does to a tumbling body.
#include <cmath>

#include <Eigen/LU>

#include "math/so3.h"
#include "motion/steppers/all.h"
#include "motion/steppers/turn.h"

namespace polhode {
namespace {

// Momentum: how the new angular momentum follows from the old one and the torque.
template <class Momentum>
class EngineEuler final : public Stepper {
 public:
  explicit EngineEuler(const BodyModel& model) : model_(model) {}

  void step(double, double h, State& s, Work& work) const override {
    const Vec3 torque = up_in_body(model_, s.q).cross(model_.chi_P);
    s.y = Momentum::next(model_, h, s.y, torque);
    s.q = normalized(s.q * turn_by(h * angular_velocity(model_, s.y)));
    ++work.evaluations;
  }

 private:
  BodyModel model_;
};

// y' = y + h (y x w + torque)
struct Explicit {
  static Vec3 next(const BodyModel& m, double h, const Vec3& y, const Vec3& torque) {
    return y + h * (y.cross(angular_velocity(m, y)) + torque);
  }
};

// One Newton step of y' = y + h (y' x w' + torque) (Catto, Numerical Methods, GDC 2015), in y: a
// rotator's missing moment is never divided by.
struct LinearlyImplicit {
  static Vec3 next(const BodyModel& m, double h, const Vec3& y, const Vec3& torque) {
    const Vec3 w = angular_velocity(m, y);
    const Mat3 slope = hat(y) * m.inverse_moments.asDiagonal();
    const Mat3 jacobian = Mat3::Identity() - h * (slope - hat(w));
    return y + jacobian.inverse() * (h * (y.cross(w) + torque));
  }
};

// y' = y + h y x w, scaled back to |y|; then the torque (the gyroscopic step of Jolt and Avian)
struct Renormalised {
  static Vec3 next(const BodyModel& m, double h, const Vec3& y, const Vec3& torque) {
    const double size = y.norm();
    if (size == 0.0) return h * torque;
    const Vec3 moved = y + h * y.cross(angular_velocity(m, y));
    return size / moved.norm() * moved + h * torque;
  }
};

}  // namespace

std::unique_ptr<Stepper> make_semi_implicit_euler(const BodyModel& model, double) {
  return std::make_unique<EngineEuler<Explicit>>(model);
}

std::unique_ptr<Stepper> make_linearly_implicit_euler(const BodyModel& model, double) {
  return std::make_unique<EngineEuler<LinearlyImplicit>>(model);
}

std::unique_ptr<Stepper> make_renormalised_explicit(const BodyModel& model, double) {
  return std::make_unique<EngineEuler<Renormalised>>(model);
}

}  // namespace polhode
