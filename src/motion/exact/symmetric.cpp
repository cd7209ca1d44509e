// SPDX-License-Identifier: MIT
#include "math/so3.h"
#include "motion/exact/exact.h"

namespace polhode {
namespace {

class ExactSpherical final : public Trajectory {
 public:
  ExactSpherical(const BodyModel& model, const State& start)
      : start_(start), w_P_(angular_velocity(model, start.y)) {}

  State at(double t) const override { return {start_.q * exp_rotation(t * w_P_), start_.y}; }

 private:
  State start_;
  Vec3 w_P_;
};

class ExactSymmetric final : public Trajectory {
 public:
  ExactSymmetric(const BodyModel& model, const State& start)
      : start_(start),
        precession_P_(start.y * model.inverse_moments[(model.kind.axis + 1) % 3]),
        axis_P_(Vec3::Unit(model.kind.axis)),
        beta_((model.inverse_moments[model.kind.axis] -
               model.inverse_moments[(model.kind.axis + 1) % 3]) *
              start.y[model.kind.axis]) {}

  State at(double t) const override {
    // turn by beta t about the own axis, then by |L| t / I1 about L
    const Quat own = exp_rotation(beta_ * t * axis_P_);
    return {start_.q * exp_rotation(t * precession_P_) * own, own.conjugate() * start_.y};
  }

 private:
  State start_;
  Vec3 precession_P_;  // L / I1, rad/s
  Vec3 axis_P_;
  double beta_;  // rad/s
};

}  // namespace

std::unique_ptr<Trajectory> exact_spherical(const BodyModel& model, const State& start) {
  return std::make_unique<ExactSpherical>(model, start);
}

std::unique_ptr<Trajectory> exact_symmetric(const BodyModel& model, const State& start) {
  return std::make_unique<ExactSymmetric>(model, start);
}

}  // namespace polhode
