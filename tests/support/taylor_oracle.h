// SPDX-License-Identifier: MIT
// The judge: dy/dt = y x w + gamma x chi, dgamma/dt = gamma x w, dq/dt = q o (0, w)/2 by Taylor
// series of order 30, in numbers with a mantissa of 64 bits or more. Shares no code with the
// program.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "model/body_model.h"

namespace polhode::test {

// for every type of numbers
using std::abs;
using std::ceil;
using std::sqrt;

template <class Number>
class BasicTaylorOracle {
 public:
  using Real = Number;
  static constexpr int kOrder = 30;
  static_assert(std::numeric_limits<Real>::digits >= 64, "the oracle needs extended precision");

  using Triple = std::array<Real, 3>;

  // moments (0: a rotator's), chi, y, q as (w, x, y, z) of any length
  BasicTaylorOracle(const Triple& moments,
                    const Triple& chi,
                    const Triple& y,
                    const std::array<Real, 4>& q,
                    const Vec3& up_S)
      : chi_(chi) {
    for (int i = 0; i < 3; ++i) {
      inverse_[i] = moments[i] > 0 ? 1 / moments[i] : 0;
      now_[i] = y[i];
    }
    const Real n = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int i = 0; i < 4; ++i)
      now_[6 + i] = q[i] / n;
    look_up(up_S);
  }

  BasicTaylorOracle(const BodyModel& model, const State& start)
      : BasicTaylorOracle(triple(model.moments),
                          triple(model.chi_P),
                          triple(start.y),
                          {start.q.w(), start.q.x(), start.q.y(), start.q.z()},
                          model.up_S) {}

  // Advances to time t (forwards or backwards) in equal steps and gives the state there.
  State at(Real t) {
    const Real rate = rate_of_change();
    const Real most = rate > 0 ? Real(0.5) / rate : Real(abs(t - t_));
    const long n = static_cast<long>(ceil(abs(t - t_) / most));
    const Real h = n > 0 ? (t - t_) / n : 0;
    for (long i = 0; i < n; ++i)
      step(h);
    t_ = t;
    return state();
  }

  State state() const {
    State s;
    s.y = Vec3(
        static_cast<double>(now_[0]), static_cast<double>(now_[1]), static_cast<double>(now_[2]));
    s.q = Quat(static_cast<double>(now_[6]),
               static_cast<double>(now_[7]),
               static_cast<double>(now_[8]),
               static_cast<double>(now_[9]));
    return s;
  }

  // y1 y2 y3, gamma1..3, q w x y z with all digits
  const std::array<Real, 10>& digits() const { return now_; }

 private:
  static Triple triple(const Vec3& v) { return {v[0], v[1], v[2]}; }

  // gamma = Q^T up from the quaternion
  void look_up(const Vec3& up) {
    const Real w = now_[6], x = now_[7], y = now_[8], z = now_[9];
    Real u[3] = {up[0], up[1], up[2]};
    const Real n = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    for (Real& c : u)
      c /= n;
    now_[3] =
        (1 - 2 * (y * y + z * z)) * u[0] + 2 * (x * y + w * z) * u[1] + 2 * (x * z - w * y) * u[2];
    now_[4] =
        2 * (x * y - w * z) * u[0] + (1 - 2 * (x * x + z * z)) * u[1] + 2 * (y * z + w * x) * u[2];
    now_[5] =
        2 * (x * z + w * y) * u[0] + 2 * (y * z - w * x) * u[1] + (1 - 2 * (x * x + y * y)) * u[2];
  }

  // bounds |w| over the whole motion: energy is conserved
  Real rate_of_change() const {
    Real energy = 0, least = 0, chi = 0;
    for (int i = 0; i < 3; ++i) {
      energy += now_[i] * now_[i] * inverse_[i] / 2;
      chi += chi_[i] * chi_[i];
      least = std::max(least, inverse_[i]);
    }
    return sqrt(2 * (energy + 2 * sqrt(chi)) * least);
  }

  // coefficient k of component i of a x b
  template <class A, class B>
  static Real cross(const A& a, const B& b, int i, int k) {
    const int j = (i + 1) % 3, l = (i + 2) % 3;
    Real sum = 0;
    for (int m = 0; m <= k; ++m)
      sum += a[j][m] * b[l][k - m] - a[l][m] * b[j][k - m];
    return sum;
  }

  void step(Real h) {
    using Series = std::array<Real, kOrder + 1>;
    std::array<Series, 3> y{}, w{}, g{};
    std::array<Series, 4> q{};
    for (int i = 0; i < 3; ++i) {
      y[i][0] = now_[i];
      g[i][0] = now_[3 + i];
    }
    for (int i = 0; i < 4; ++i)
      q[i][0] = now_[6 + i];
    for (int k = 0; k < kOrder; ++k) {
      for (int i = 0; i < 3; ++i)
        w[i][k] = inverse_[i] * y[i][k];
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, l = (i + 2) % 3;
        y[i][k + 1] = (cross(y, w, i, k) + g[j][k] * chi_[l] - g[l][k] * chi_[j]) / (k + 1);
        g[i][k + 1] = cross(g, w, i, k) / (k + 1);
      }
      Real r[4] = {};
      for (int m = 0; m <= k; ++m) {
        const Real a = w[0][k - m], b = w[1][k - m], c = w[2][k - m];
        r[0] += -q[1][m] * a - q[2][m] * b - q[3][m] * c;
        r[1] += q[0][m] * a + q[2][m] * c - q[3][m] * b;
        r[2] += q[0][m] * b + q[3][m] * a - q[1][m] * c;
        r[3] += q[0][m] * c + q[1][m] * b - q[2][m] * a;
      }
      for (int i = 0; i < 4; ++i)
        q[i][k + 1] = r[i] / (2 * (k + 1));
    }
    const auto sum = [h](const Series& s) {
      Real total = 0;
      for (int k = kOrder; k >= 0; --k)
        total = total * h + s[k];
      return total;
    };
    for (int i = 0; i < 3; ++i) {
      now_[i] = sum(y[i]);
      now_[3 + i] = sum(g[i]);
    }
    for (int i = 0; i < 4; ++i)
      now_[6 + i] = sum(q[i]);
  }

  Triple inverse_{}, chi_{};
  std::array<Real, 10> now_{};
  Real t_ = 0;
};

using TaylorOracle = BasicTaylorOracle<long double>;

}  // namespace polhode::test
