// SPDX-License-Identifier: MIT
// Explicit Euler, the classical Runge-Kutta method, and Dormand and Prince's pair 5(4), all on (q,
// y) with q scaled back to unit length after the step.
#include <algorithm>

#include "motion/steppers/all.h"
#include "motion/steppers/derivative.h"

namespace polhode {
namespace {

class ExplicitEuler final : public Stepper {
 public:
  explicit ExplicitEuler(const Model& model) : model_(model) {}

  void step(double, double h, State& s) override {
    const Vec7 v = to_vector(s);
    s = to_state(v + h * derivative(model_, v));
    ++evaluations_;
  }

 private:
  Model model_;
};

class RungeKutta4 final : public Stepper {
 public:
  explicit RungeKutta4(const Model& model) : model_(model) {}

  void step(double, double h, State& s) override {
    const Vec7 v = to_vector(s);
    const Vec7 k1 = derivative(model_, v);
    const Vec7 k2 = derivative(model_, v + 0.5 * h * k1);
    const Vec7 k3 = derivative(model_, v + 0.5 * h * k2);
    const Vec7 k4 = derivative(model_, v + h * k3);
    s = to_state(v + h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4));
    evaluations_ += 4;
  }

 private:
  Model model_;
};

// Coefficients: Dormand and Prince 1980, table 2 (RK5(4)7M).
class DormandPrince5 final : public Stepper {
 public:
  DormandPrince5(const Model& model, double momentum_scale)
      : model_(model), momentum_scale_(momentum_scale) {}

  void step(double t, double h, State& s) override { step_with_error(t, h, s); }

  double step_with_error(double, double h, State& s) override {
    const Vec7 v = to_vector(s);
    const Vec7 k1 = derivative(model_, v);
    const Vec7 k2 = derivative(model_, v + h * (1.0 / 5 * k1));
    const Vec7 k3 = derivative(model_, v + h * (3.0 / 40 * k1 + 9.0 / 40 * k2));
    const Vec7 k4 = derivative(model_, v + h * (44.0 / 45 * k1 - 56.0 / 15 * k2 + 32.0 / 9 * k3));
    const Vec7 k5 = derivative(model_,
                               v + h * (19372.0 / 6561 * k1 - 25360.0 / 2187 * k2 +
                                        64448.0 / 6561 * k3 - 212.0 / 729 * k4));
    const Vec7 k6 = derivative(model_,
                               v + h * (9017.0 / 3168 * k1 - 355.0 / 33 * k2 + 46732.0 / 5247 * k3 +
                                        49.0 / 176 * k4 - 5103.0 / 18656 * k5));
    const Vec7 end = v + h * (35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 -
                              2187.0 / 6784 * k5 + 11.0 / 84 * k6);
    const Vec7 k7 = derivative(model_, end);
    evaluations_ += 7;

    // difference of the two embedded solutions
    const Vec7 error = h * (71.0 / 57600 * k1 - 71.0 / 16695 * k3 + 71.0 / 1920 * k4 -
                            17253.0 / 339200 * k5 + 22.0 / 525 * k6 - 1.0 / 40 * k7);
    s = to_state(end);
    return std::max(error.head<4>().norm(), error.tail<3>().norm() / momentum_scale_);
  }

 private:
  Model model_;
  double momentum_scale_;
};

}  // namespace

std::unique_ptr<Stepper> make_explicit_euler(const Model& model, double) {
  return std::make_unique<ExplicitEuler>(model);
}

std::unique_ptr<Stepper> make_rk4(const Model& model, double) {
  return std::make_unique<RungeKutta4>(model);
}

std::unique_ptr<Stepper> make_dopri5(const Model& model, double momentum_scale) {
  return std::make_unique<DormandPrince5>(model, momentum_scale);
}

}  // namespace polhode
