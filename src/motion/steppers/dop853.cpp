// SPDX-License-Identifier: MIT
// Dormand and Prince's method of order 8 (motion/steppers/dormand_prince.h) for a body.
#include "motion/steppers/all.h"
#include "motion/steppers/derivative.h"
#include "motion/steppers/dormand_prince.h"

namespace polhode {
namespace {

template <int N>
class DormandPrince853 final : public Stepper {
 public:
  DormandPrince853(const BodyModel& model, double momentum_scale)
      : model_(model), norm_(model, momentum_scale) {}

  void step(double t, double h, State& s, Work& work) const override {
    step_with_error(t, h, s, work);
  }

  double step_with_error(double t, double h, State& s, Work& work) const override {
    const Vector v = to_vector<N>(s);
    double error = 0.0;
    const Vector change = dormand_prince::step_of_order_8(
        t,
        h,
        v,
        [&](double at, const Vector& now) -> Vector { return derivative<N>(model_, at, now); },
        [&](const Vector& e) { return norm_.template of<N>(e); },
        error);
    work.evaluations += dormand_prince::kStages;
    set_state<N>(model_, v + change, s);
    return error;
  }

 private:
  using Vector = StateVector<N>;

  BodyModel model_;
  ErrorNorm norm_;
};

}  // namespace

std::unique_ptr<Stepper> make_dop853(const BodyModel& model, double momentum_scale) {
  return make_on_vector<DormandPrince853>(model, momentum_scale);
}

}  // namespace polhode
