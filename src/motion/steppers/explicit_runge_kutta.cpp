// SPDX-License-Identifier: MIT
// Explicit Euler, the explicit midpoint method, the classical Runge-Kutta method, and Dormand and
// Prince's pair 5(4), all on the state as a vector, with q scaled back to unit length after the
// step.
#include "motion/steppers/all.h"
#include "motion/steppers/derivative.h"

namespace polhode {
namespace {

template <int N>
class ExplicitEuler final : public Stepper {
 public:
  explicit ExplicitEuler(const BodyModel& model) : model_(model) {}

  void step(double t, double h, State& s, Work& work) const override {
    const Vector v = to_vector<N>(s);
    set_state<N>(model_, v + h * derivative<N>(model_, t, v), s);
    ++work.evaluations;
  }

 private:
  using Vector = StateVector<N>;

  BodyModel model_;
};

// The midpoint method.
template <int N>
class RungeKutta2 final : public Stepper {
 public:
  explicit RungeKutta2(const BodyModel& model) : model_(model) {}

  void step(double t, double h, State& s, Work& work) const override {
    const Vector v = to_vector<N>(s);
    const Vector k1 = derivative<N>(model_, t, v);
    set_state<N>(model_, v + h * derivative<N>(model_, t + 0.5 * h, v + 0.5 * h * k1), s);
    work.evaluations += 2;
  }

 private:
  using Vector = StateVector<N>;

  BodyModel model_;
};

template <int N>
class RungeKutta4 final : public Stepper {
 public:
  explicit RungeKutta4(const BodyModel& model) : model_(model) {}

  void step(double t, double h, State& s, Work& work) const override {
    const Vector v = to_vector<N>(s);
    const Vector k1 = derivative<N>(model_, t, v);
    const Vector k2 = derivative<N>(model_, t + 0.5 * h, v + 0.5 * h * k1);
    const Vector k3 = derivative<N>(model_, t + 0.5 * h, v + 0.5 * h * k2);
    const Vector k4 = derivative<N>(model_, t + h, v + h * k3);
    set_state<N>(model_, v + h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4), s);
    work.evaluations += 4;
  }

 private:
  using Vector = StateVector<N>;

  BodyModel model_;
};

// Coefficients: Dormand and Prince 1980, table 2 (RK5(4)7M).
template <int N>
class DormandPrince5 final : public Stepper {
 public:
  DormandPrince5(const BodyModel& model, double momentum_scale)
      : model_(model), norm_(model, momentum_scale) {}

  // without the seventh stage, which only the estimate needs
  void step(double t, double h, State& s, Work& work) const override {
    advance<false>(t, h, s, work);
  }

  double step_with_error(double t, double h, State& s, Work& work) const override {
    return advance<true>(t, h, s, work);
  }

 private:
  using Vector = StateVector<N>;

  BodyModel model_;
  ErrorNorm norm_;

  template <bool WithError>
  double advance(double t, double h, State& s, Work& work) const {
    const Vector v = to_vector<N>(s);
    const Vector k1 = derivative<N>(model_, t, v);
    const Vector k2 = derivative<N>(model_, t + h / 5.0, v + h * (1.0 / 5 * k1));
    const Vector k3 = derivative<N>(model_, t + 0.3 * h, v + h * (3.0 / 40 * k1 + 9.0 / 40 * k2));
    const Vector k4 = derivative<N>(
        model_, t + 0.8 * h, v + h * (44.0 / 45 * k1 - 56.0 / 15 * k2 + 32.0 / 9 * k3));
    const Vector k5 = derivative<N>(model_,
                                    t + 8.0 / 9.0 * h,
                                    v + h * (19372.0 / 6561 * k1 - 25360.0 / 2187 * k2 +
                                             64448.0 / 6561 * k3 - 212.0 / 729 * k4));
    const Vector k6 =
        derivative<N>(model_,
                      t + h,
                      v + h * (9017.0 / 3168 * k1 - 355.0 / 33 * k2 + 46732.0 / 5247 * k3 +
                               49.0 / 176 * k4 - 5103.0 / 18656 * k5));
    const Vector end = v + h * (35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 -
                                2187.0 / 6784 * k5 + 11.0 / 84 * k6);
    set_state<N>(model_, end, s);
    work.evaluations += 6;
    if constexpr (!WithError) return 0.0;
    const Vector k7 = derivative<N>(model_, t + h, end);
    ++work.evaluations;

    // difference of the two embedded solutions
    const Vector error = h * (71.0 / 57600 * k1 - 71.0 / 16695 * k3 + 71.0 / 1920 * k4 -
                              17253.0 / 339200 * k5 + 22.0 / 525 * k6 - 1.0 / 40 * k7);
    return norm_.template of<N>(error, v, h);
  }
};

}  // namespace

std::unique_ptr<Stepper> make_explicit_euler(const BodyModel& model, double) {
  return make_on_vector<ExplicitEuler>(model);
}

std::unique_ptr<Stepper> make_rk2(const BodyModel& model, double) {
  return make_on_vector<RungeKutta2>(model);
}

std::unique_ptr<Stepper> make_rk4(const BodyModel& model, double) {
  return make_on_vector<RungeKutta4>(model);
}

std::unique_ptr<Stepper> make_dopri5(const BodyModel& model, double momentum_scale) {
  return make_on_vector<DormandPrince5>(model, momentum_scale);
}

}  // namespace polhode
