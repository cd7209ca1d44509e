// SPDX-License-Identifier: MIT
// Radau IIA of order 5 (motion/steppers/radau_step.h) for a body.
#include <cmath>
#include <limits>

#include "motion/steppers/all.h"
#include "motion/steppers/derivative.h"
#include "motion/steppers/no_solution.h"
#include "motion/steppers/radau_step.h"

namespace polhode {
namespace {

template <int N>
class Radau5 final : public Stepper {
 public:
  Radau5(const BodyModel& model, double momentum_scale)
      : model_(model), norm_(model, momentum_scale) {}

  void step(double t, double h, State& s, Work& work) const override {
    const Vec3 y = s.y;
    if (std::isinf(step_with_error(t, h, s, work)))
      throw no_solution("radau5", t, h, model_, y, "take a smaller tolerance");
  }

  double step_with_error(double t, double h, State& s, Work& work) const override {
    if (h == 0.0) return 0.0;
    const Vector v = to_vector<N>(s);
    const auto slope = [&](double at, const Vector& now) -> Vector {
      ++work.evaluations;
      return derivative<N>(model_, at, now);
    };
    const auto size = [&](const Vector& e) {
      return norm_.template of<N>(e, v, h);
    };
    double error = 0.0;
    const Vector change =
        RadauStep<Vector, decltype(slope), decltype(size)>(slope, size)(t, h, v, error);
    // without a solution s is not changed
    if (!std::isinf(error)) set_state<N>(model_, v + change, s);
    return error;
  }

 private:
  using Vector = StateVector<N>;

  BodyModel model_;
  ErrorNorm norm_;
};

}  // namespace

std::unique_ptr<Stepper> make_radau5(const BodyModel& model, double momentum_scale) {
  return make_on_vector<Radau5>(model, momentum_scale);
}

}  // namespace polhode
