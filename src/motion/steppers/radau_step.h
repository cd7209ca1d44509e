// SPDX-License-Identifier: MIT
// Radau IIA of order 5 with three stages, for any vector: L-stable, so that its step does not have
// to resolve what strong damping has already brought to rest. Hairer and Wanner, Solving Ordinary
// Differential Equations II, IV.5 (coefficients) and IV.8 (Newton's method on z = increments of the
// stages, starting values, estimate of the error).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <Eigen/LU>

namespace polhode {

// How a step's equations are solved.
struct RadauSettings {
  // Newton's method ends when its last change is as small as this; as round-off, if that is more.
  double enough = 0.0;
  // Numbers are changed by this part of their typical size to find the Jacobian.
  double difference = 1e-8;
  // Where the Jacobian is taken, as a part of the step: 0 for damping that is the same over the
  // step, 0.5 for one that is not, from a start on which it has worked already.
  double place = 0.0;
};

// Steps of dv/dt = slope(t, v), where size(v) is the norm of an error.
template <class Vector, class Slope, class Size>
class RadauStep {
 public:
  RadauStep(const Slope& slope, const Size& size, const RadauSettings& settings = {})
      : slope_(slope), size_(size), settings_(settings) {}

  // The change of v in a step h (s) from t (s). Sets `error` to the estimate of the local error;
  // infinite if Newton's method does not converge.
  Vector operator()(double t, double h, const Vector& v, double& error) const {
    const Vector rate = slope_(t, v);
    const Square jacobian = jacobian_at(t, h, v, rate);

    // (1 - h A x J) dz = h (A x 1) f(v + z) - z, with one Jacobian for all iterations
    System system = System::Identity();
    for (int i = 0; i < kStages; ++i) {
      for (int j = 0; j < kStages; ++j) {
        system.template block<kNumbers, kNumbers>(kNumbers * i, kNumbers * j) -=
            h * kA[i][j] * jacobian;
      }
    }
    const Eigen::PartialPivLU<System> inverse(system);
    Stages z = Stages::Zero();
    error = std::numeric_limits<double>::infinity();
    if (!solve(t, h, v, inverse, z)) return Vector::Zero();

    // (1/h gamma - J) error = f(v) + (e1 z1 + e2 z2 + e3 z3) / h, twice: the filter keeps what is
    // stiff from being taken for an error
    const Square filter = kGamma / h * Square::Identity() - jacobian;
    const Eigen::PartialPivLU<Square> filtered(filter);
    const Vector sum = (kE[0] * z.col(0) + kE[1] * z.col(1) + kE[2] * z.col(2)) / h;
    const Vector first = filtered.solve(rate + sum);
    error = size_(Vector(filtered.solve(slope_(t, Vector(v + first)) + sum)));
    return z.col(2);
  }

 private:
  static constexpr int kNumbers = Vector::RowsAtCompileTime;
  static constexpr int kStages = 3;
  static constexpr int kMostIterations = 30;
  using Square = Eigen::Matrix<double, kNumbers, kNumbers>;
  using Stages = Eigen::Matrix<double, kNumbers, kStages>;
  using System = Eigen::Matrix<double, kNumbers * kStages, kNumbers * kStages>;
  using AllStages = Eigen::Matrix<double, kNumbers * kStages, 1>;

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

  // by differences
  Square jacobian_at(double t, double h, const Vector& v, const Vector& rate) const {
    const double typical = size_(v);
    const double ahead = settings_.place * h;
    const Vector middle = v + ahead * rate;
    const Vector middle_rate = ahead != 0.0 ? slope_(t + ahead, middle) : rate;
    Square jacobian;
    for (int i = 0; i < kNumbers; ++i) {
      const Vector unit = Vector::Unit(i);
      const double scale = typical / size_(unit);
      const double change =
          settings_.difference * (scale > 0.0 && std::isfinite(scale) ? scale : 1.0);
      jacobian.col(i) = (slope_(t + ahead, Vector(middle + change * unit)) - middle_rate) / change;
    }
    return jacobian;
  }

  // simplified Newton iterations; false if they do not converge
  bool solve(double t,
             double h,
             const Vector& v,
             const Eigen::PartialPivLU<System>& inverse,
             Stages& z) const {
    const double enough = std::max(settings_.enough, kRoundOff);
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      Stages rates;
      for (int i = 0; i < kStages; ++i)
        rates.col(i) = slope_(t + kC[i] * h, Vector(v + z.col(i)));
      AllStages residual;
      for (int i = 0; i < kStages; ++i) {
        residual.template segment<kNumbers>(kNumbers * i) =
            h * (kA[i][0] * rates.col(0) + kA[i][1] * rates.col(1) + kA[i][2] * rates.col(2)) -
            z.col(i);
      }
      const AllStages change = inverse.solve(residual);
      double size = 0.0;
      for (int i = 0; i < kStages; ++i) {
        z.col(i) += change.template segment<kNumbers>(kNumbers * i);
        size = std::max(size, size_(Vector(change.template segment<kNumbers>(kNumbers * i))));
      }
      if (!std::isfinite(size)) return false;
      // round-off stops the descent
      if (size <= enough || (size >= 0.5 * last && size <= 1e3 * kRoundOff)) return true;
      if (size >= 2.0 * last) return false;
      last = size;
    }
    return last <= 1e3 * kRoundOff;
  }

  static constexpr double kRoundOff = 4.0 * std::numeric_limits<double>::epsilon();
  const Slope& slope_;
  const Size& size_;
  RadauSettings settings_;
};

}  // namespace polhode
