// SPDX-License-Identifier: MIT
// Radau IIA of order 5 with three stages: L-stable, so that its step does not have to resolve what
// strong damping has already brought to rest. Hairer and Wanner, Solving Ordinary Differential
// Equations II, IV.5 (coefficients) and IV.8 (Newton's method on z = increments of the stages,
// starting values, estimate of the error).
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "motion/steppers/all.h"
#include "motion/steppers/derivative.h"
#include "motion/steppers/no_solution.h"

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
    constexpr double kFailed = std::numeric_limits<double>::infinity();
    if (h == 0.0) return 0.0;
    const Vector v = to_vector<N>(s);
    const Vector rate = derivative<N>(model_, t, v);
    const Square jacobian = jacobian_at(t, v, rate, work);

    // (1 - h A x J) dz = h (A x 1) f(v + z) - z, with one Jacobian for all iterations
    System system = System::Identity();
    for (int i = 0; i < kStages; ++i) {
      for (int j = 0; j < kStages; ++j)
        system.template block<N, N>(N * i, N * j) -= h * kA[i][j] * jacobian;
    }
    const Eigen::PartialPivLU<System> inverse(system);
    Stages z = Stages::Zero();
    if (!solve(t, h, v, inverse, z, work)) return kFailed;  // s is not changed

    // (1/h gamma - J) error = f(v) + (e1 z1 + e2 z2 + e3 z3) / h, twice: the filter keeps what is
    // stiff from being taken for an error
    const Square filter = kGamma / h * Square::Identity() - jacobian;
    const Eigen::PartialPivLU<Square> filtered(filter);
    const Vector sum = (kE[0] * z.col(0) + kE[1] * z.col(1) + kE[2] * z.col(2)) / h;
    Vector error = filtered.solve(rate + sum);
    error = filtered.solve(derivative<N>(model_, t, v + error) + sum);
    ++work.evaluations;
    set_state<N>(model_, v + z.col(2), s);
    return norm_.template of<N>(error);
  }

 private:
  static constexpr int kStages = 3;
  static constexpr int kMostIterations = 12;
  using Vector = StateVector<N>;
  using Square = Eigen::Matrix<double, N, N>;
  using Stages = Eigen::Matrix<double, N, kStages>;
  using System = Eigen::Matrix<double, N * kStages, N * kStages>;
  using AllStages = Eigen::Matrix<double, N * kStages, 1>;

  static constexpr double kRoot6 = 2.449489742783178;
  static constexpr double kC[kStages] = {(4.0 - kRoot6) / 10.0, (4.0 + kRoot6) / 10.0, 1.0};
  static constexpr double kA[kStages][kStages] = {
      {(88.0 - 7.0 * kRoot6) / 360.0,
       (296.0 - 169.0 * kRoot6) / 1800.0,
       (-2.0 + 3.0 * kRoot6) / 225.0},
      {(296.0 + 169.0 * kRoot6) / 1800.0,
       (88.0 + 7.0 * kRoot6) / 360.0,
       (-2.0 - 3.0 * kRoot6) / 225.0},
      {(16.0 - kRoot6) / 36.0, (16.0 + kRoot6) / 36.0, 1.0 / 9.0}};
  // the real eigenvalue of the inverse of A, and the weights of the estimate
  static constexpr double kGamma = 3.637834252744496;
  static constexpr double kE[kStages] = {
      -(13.0 + 7.0 * kRoot6) / 3.0, (-13.0 + 7.0 * kRoot6) / 3.0, -1.0 / 3.0};

  // by differences, each number changed by the root of its round-off
  Square jacobian_at(double t, const Vector& v, const Vector& rate, Work& work) const {
    const double typical = norm_.template of<N>(v);
    Square jacobian;
    for (int i = 0; i < N; ++i) {
      Vector unit = Vector::Unit(i);
      const double scale = typical / norm_.template of<N>(unit);
      const double change = 1e-8 * (scale > 0.0 ? scale : 1.0);
      jacobian.col(i) = (derivative<N>(model_, t, v + change * unit) - rate) / change;
    }
    work.evaluations += N + 1;
    return jacobian;
  }

  // simplified Newton iterations; false if they do not converge
  bool solve(double t,
             double h,
             const Vector& v,
             const Eigen::PartialPivLU<System>& inverse,
             Stages& z,
             Work& work) const {
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      Stages rates;
      for (int i = 0; i < kStages; ++i)
        rates.col(i) = derivative<N>(model_, t + kC[i] * h, v + z.col(i));
      work.evaluations += kStages;
      AllStages residual;
      for (int i = 0; i < kStages; ++i) {
        residual.template segment<N>(N * i) =
            h * (kA[i][0] * rates.col(0) + kA[i][1] * rates.col(1) + kA[i][2] * rates.col(2)) -
            z.col(i);
      }
      const AllStages change = inverse.solve(residual);
      double size = 0.0;
      for (int i = 0; i < kStages; ++i) {
        z.col(i) += change.template segment<N>(N * i);
        size = std::max(size, norm_.template of<N>(change.template segment<N>(N * i)));
      }
      if (!std::isfinite(size)) return false;
      // round-off stops the descent
      if (size <= kRoundOff || (size >= 0.5 * last && size <= 1e3 * kRoundOff)) return true;
      if (size >= 2.0 * last) return false;
      last = size;
    }
    return last <= 1e3 * kRoundOff;
  }

  static constexpr double kRoundOff = 4.0 * std::numeric_limits<double>::epsilon();
  BodyModel model_;
  ErrorNorm norm_;
};

}  // namespace

std::unique_ptr<Stepper> make_radau5(const BodyModel& model, double momentum_scale) {
  return make_on_vector<Radau5>(model, momentum_scale);
}

}  // namespace polhode
