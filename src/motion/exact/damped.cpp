// SPDX-License-Identifier: MIT
// Isotropic damping as a change of clock.
#include <cmath>
#include <utility>

#include "motion/exact/exact.h"

namespace polhode {
namespace {

class Damped final : public Trajectory {
 public:
  Damped(std::unique_ptr<Trajectory> undamped, double c) : undamped_(std::move(undamped)), c_(c) {}

  State at(double t) const override {
    State s = undamped_->at(-std::expm1(-c_ * t) / c_);
    s.y *= std::exp(-c_ * t);
    return s;
  }

 private:
  std::unique_ptr<Trajectory> undamped_;
  double c_;  // 1/s
};

}  // namespace

std::unique_ptr<Trajectory> damped(std::unique_ptr<Trajectory> undamped, double c) {
  return std::make_unique<Damped>(std::move(undamped), c);
}

}  // namespace polhode
